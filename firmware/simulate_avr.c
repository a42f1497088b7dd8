/* Runs an ATmega328P's program in simavr in true time, or slower: its serial line on standard input and output; at the end the median of the last pulses on
 * each of the six servo pins, in microseconds, on standard error. For tests; needs libsimavr.
 *
 *     cc -o simulate_avr simulate_avr.c -lsimavr -lelf && ./simulate_avr servos.elf */
#define _POSIX_C_SOURCE 200809L
#include <poll.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define SERVOS 6
#define HERTZ 16000000UL
/* The seconds of the board's time between two looks at the line. */
#define LONGEST_TURN 0.005

static avr_t *avr;
static uint8_t output[4096];
static size_t count;
static uint64_t rose[SERVOS];
#define LAST 9
static unsigned pulse[SERVOS][LAST];
static unsigned pulses[SERVOS];
static int is_full;

static void sent(struct avr_irq_t *irq, uint32_t value, void *unused)
{
    (void)irq, (void)unused;
    if (count < sizeof output)
        output[count++] = (uint8_t)value;
}

static void allow(struct avr_irq_t *irq, uint32_t value, void *unused)
{
    (void)irq, (void)value, (void)unused;
    is_full = 0;
}

static void deny(struct avr_irq_t *irq, uint32_t value, void *unused)
{
    (void)irq, (void)value, (void)unused;
    is_full = 1;
}

static void pin_moved(struct avr_irq_t *irq, uint32_t value, void *index)
{
    (void)irq;
    size_t servo = (size_t)index;
    if (value)
        rose[servo] = avr->cycle;
    else if (rose[servo])
        pulse[servo][pulses[servo]++ % LAST] = (unsigned)((avr->cycle - rose[servo]) / (HERTZ / 1000000));
}

/* Of the last pulses: single ones are a few microseconds off where an interrupt waits for another. */
static unsigned median(unsigned *values)
{
    for (int k = 1; k < LAST; k++)
        for (int j = k; j > 0 && values[j - 1] > values[j]; j--) {
            unsigned swapped = values[j];
            values[j] = values[j - 1];
            values[j - 1] = swapped;
        }
    return values[LAST / 2];
}

static double seconds(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

int main(int argc, char **argv)
{
    static const struct { char port; int bit; } pins[SERVOS] = {{'D', 3}, {'D', 5}, {'D', 6}, {'B', 1}, {'B', 2}, {'B', 3}};
    elf_firmware_t firmware;
    memset(&firmware, 0, sizeof firmware);
    if (argc != 2 || elf_read_firmware(argv[1], &firmware) != 0) {
        fprintf(stderr, "simulate_avr: a program was expected\n");
        return 2;
    }
    avr = avr_make_mcu_by_name("atmega328p");
    if (!avr || avr_init(avr) != 0)
        return 2;
    firmware.frequency = HERTZ;
    avr_load_firmware(avr, &firmware);
    uint32_t flags = 0;
    avr_ioctl(avr, AVR_IOCTL_UART_GET_FLAGS('0'), &flags);
    flags &= ~(uint32_t)AVR_UART_FLAG_STDIO;
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), sent, NULL);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUT_XON), allow, NULL);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUT_XOFF), deny, NULL);
    avr_irq_t *line = avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT);
    for (size_t servo = 0; servo < SERVOS; servo++)
        avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ(pins[servo].port), pins[servo].bit), pin_moved, (void *)servo);
    /* The button is not pressed. */
    avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), 2), 1);

    struct pollfd input = {.fd = 0, .events = POLLIN};
    uint8_t bytes[512];
    ssize_t have = 0, given = 0;
    double begun = seconds();
    for (;;) {
        /* As many cycles as time has passed, in steps of a fifth of a millisecond. Where this computer is too slow or too busy for that,
         * the board's time goes slower, as if it had not been owed: a board that hurries after the time would hear of the past only. What is
         * owed is fixed before the cycles are run: a computer that only just keeps up would else never come to the line. */
        double owed = seconds() - begun - (double)avr->cycle / HERTZ;
        if (owed > LONGEST_TURN) {
            begun += owed - LONGEST_TURN;
            owed = LONGEST_TURN;
        }
        uint64_t until = avr->cycle + (owed > 0 ? (uint64_t)(owed * HERTZ) : 0);
        while (avr->cycle < until) {
            uint64_t end = avr->cycle + HERTZ / 5000;
            while (avr->cycle < end) {
                if (given < have && !is_full)
                    avr_raise_irq(line, bytes[given++]);
                int state = avr_run(avr);
                if (state == cpu_Done || state == cpu_Crashed) {
                    fprintf(stderr, "simulate_avr: the program crashed\n");
                    return 1;
                }
            }
        }
        if (count > 0 && write(1, output, count) < 0)
            return 1;
        count = 0;
        if (given == have && poll(&input, 1, 0) > 0) {
            have = read(0, bytes, sizeof bytes);
            given = 0;
            if (have <= 0)
                break;
        }
        struct timespec pause = {.tv_nsec = 300000};
        nanosleep(&pause, NULL);
    }
    for (size_t servo = 0; servo < SERVOS; servo++)
        fprintf(stderr, "%u\n", median(pulse[servo]));
    return 0;
}
