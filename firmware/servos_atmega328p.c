/* Six hobby servos on an Arduino Uno or Nano (ATmega328P at 16 MHz): pins 3, 5, 6, 9, 10 and 11; the serial line at 115200 baud; a
 * button between pin 2 and ground is the emergency stop.
 *
 *     avr-gcc -mmcu=atmega328p -DF_CPU=16000000UL -std=c99 -Os -Wall -Wextra -Werror -o servos.elf servos_atmega328p.c pieper_packets.c
 *     avrdude -p m328p -c arduino -P /dev/ttyACM0 -U flash:w:servos.elf */
#include <avr/interrupt.h>
#include <avr/io.h>
#include <stddef.h>

#include "pieper_packets.h"

#define SERVOS 6
/* 0 to 180 degrees in micro-radians, and the pulses for them in microseconds, as the Arduino library has them. */
#define HALF_TURN 3141593L
#define SHORTEST 544UL
#define LONGEST 2400UL
/* Two timer ticks a microsecond; a servo's turn to be pulsed comes every 20 ms, in slots of 3.3 ms. */
#define SLOT 6667U

static const struct pieper_axis axes[SERVOS] = {
    {0, HALF_TURN, 6000}, {0, HALF_TURN, 6000}, {0, HALF_TURN, 6000},
    {0, HALF_TURN, 6000}, {0, HALF_TURN, 6000}, {0, HALF_TURN, 6000},
};
static const int32_t middle[SERVOS] = {
    HALF_TURN / 2, HALF_TURN / 2, HALF_TURN / 2, HALF_TURN / 2, HALF_TURN / 2, HALF_TURN / 2,
};

/* Which pin of which port: 3, 5 and 6 are of port D, 9 to 11 of port B. */
static const struct { volatile uint8_t *port; uint8_t bit; } pins[SERVOS] = {
    {&PORTD, 1 << 3}, {&PORTD, 1 << 5}, {&PORTD, 1 << 6}, {&PORTB, 1 << 1}, {&PORTB, 1 << 2}, {&PORTB, 1 << 3},
};

static struct pieper_device device;
static volatile uint32_t milliseconds;
static volatile uint16_t pulse[SERVOS];
static volatile uint8_t slot;
static volatile uint8_t received[128];
static volatile uint8_t head;
static uint8_t tail;

ISR(TIMER0_COMPA_vect) { milliseconds++; }

/* A slot begins: the servo's pin goes up, and the pulse is counted from then on, however late the interrupt was served. */
ISR(TIMER1_COMPA_vect)
{
    *pins[slot].port |= pins[slot].bit;
    OCR1B = TCNT1 + pulse[slot];
}

/* The pulse ends; the next slot is the next servo's. */
ISR(TIMER1_COMPB_vect)
{
    *pins[slot].port &= (uint8_t)~pins[slot].bit;
    slot = (uint8_t)((slot + 1) % SERVOS);
}

ISR(USART_RX_vect)
{
    received[head] = UDR0;
    head = (uint8_t)((head + 1) % sizeof received);
}

static void send_byte(uint8_t byte)
{
    while (!(UCSR0A & (1 << UDRE0))) {
    }
    UDR0 = byte;
}

static uint32_t now(void)
{
    cli();
    uint32_t time = milliseconds;
    sei();
    return time;
}

static void set_up(void)
{
    DDRD |= 1 << 3 | 1 << 5 | 1 << 6;
    DDRB |= 1 << 1 | 1 << 2 | 1 << 3;
    PORTD |= 1 << 2; /* the button pulls pin 2 down */
    /* A millisecond: 16 MHz / 64 / 250. */
    TCCR0A = 1 << WGM01;
    TCCR0B = 1 << CS01 | 1 << CS00;
    OCR0A = 249;
    TIMSK0 = 1 << OCIE0A;
    /* Half microseconds: 16 MHz / 8, cleared at the slot's end. */
    TCCR1B = 1 << WGM12 | 1 << CS11;
    OCR1A = SLOT - 1;
    OCR1B = SLOT; /* past the slot's end: it is set when a pulse begins */
    TIMSK1 = 1 << OCIE1A | 1 << OCIE1B;
    /* 115200 baud at double speed: 16 MHz / 8 / 115200 = 17.4. */
    UCSR0A = 1 << U2X0;
    UBRR0 = 16;
    UCSR0B = 1 << RXEN0 | 1 << TXEN0 | 1 << RXCIE0;
    UCSR0C = 1 << UCSZ01 | 1 << UCSZ00;
}

/* The pulse for a position, in half microseconds: in 32 bits, so the position is taken in 64ths. */
static uint16_t pulse_of(int32_t position)
{
    return (uint16_t)(2 * SHORTEST + (uint32_t)(position >> 6) * (2 * (LONGEST - SHORTEST)) / (HALF_TURN >> 6));
}

int main(void)
{
    pieper_init(&device, SERVOS, axes, middle, "six servos", send_byte);
    for (uint8_t servo = 0; servo < SERVOS; servo++)
        pulse[servo] = pulse_of(device.position[servo]);
    set_up();
    sei();
    for (;;) {
        while (tail != head) {
            pieper_receive(&device, received[tail], now());
            tail = (uint8_t)((tail + 1) % sizeof received);
        }
        pieper_emergency_stop(&device, !(PIND & 1 << 2));
        pieper_tick(&device, now());
        for (uint8_t servo = 0; servo < SERVOS; servo++) {
            uint16_t wanted = pulse_of(device.position[servo]);
            cli();
            pulse[servo] = wanted;
            sei();
        }
    }
}
