/* The same six servos on a desktop computer, between standard input and output: for tests of the firmware without a board. */
#define _POSIX_C_SOURCE 200809L
#include <poll.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

#include "pieper_packets.h"

#define SERVOS 6
#define HALF_TURN 3141593L

static const struct pieper_axis axes[SERVOS] = {
    {0, HALF_TURN, 6000}, {0, HALF_TURN, 6000}, {0, HALF_TURN, 6000},
    {0, HALF_TURN, 6000}, {0, HALF_TURN, 6000}, {0, HALF_TURN, 6000},
};
static const int32_t middle[SERVOS] = {
    HALF_TURN / 2, HALF_TURN / 2, HALF_TURN / 2, HALF_TURN / 2, HALF_TURN / 2, HALF_TURN / 2,
};

static uint8_t waiting[512];
static size_t count;

static void send_byte(uint8_t byte)
{
    if (count < sizeof waiting)
        waiting[count++] = byte;
}

static uint32_t now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (uint32_t)(time.tv_sec * 1000 + time.tv_nsec / 1000000);
}

int main(void)
{
    static struct pieper_device device;
    struct pollfd input = {.fd = 0, .events = POLLIN};
    pieper_init(&device, SERVOS, axes, middle, "six servos", send_byte);
    device.ticked = now();
    for (;;) {
        if (poll(&input, 1, 1) > 0) {
            uint8_t bytes[256];
            ssize_t got = read(0, bytes, sizeof bytes);
            if (got <= 0)
                return 0;
            for (ssize_t k = 0; k < got; k++)
                pieper_receive(&device, bytes[k], now());
        }
        pieper_tick(&device, now());
        if (count > 0 && write(1, waiting, count) < 0)
            return 1;
        count = 0;
    }
}
