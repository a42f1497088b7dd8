/* The controller's side of pieper's state packets (docs/link.md, section 2), in portable C99: no allocation, no floating point, no
 * library beyond the language. A board calls three functions and reads one array:
 *
 *     static struct pieper_device device;
 *     pieper_init(&device, 6, ranges, "my arm", send_byte);
 *     for (;;) {
 *         while (a byte came) pieper_receive(&device, byte, milliseconds());
 *         pieper_tick(&device, milliseconds());
 *         for (k = 0; k < device.count; k++) drive motor k to device.position[k];
 *     }
 *
 * Positions are micro-radians, or micrometres of a motor that slides. */
#ifndef PIEPER_PACKETS_H
#define PIEPER_PACKETS_H

#include <stdbool.h>
#include <stdint.h>

#define PIEPER_VERSION 1
#define PIEPER_AXES 12
#define PIEPER_PERIOD_MS 20
#define PIEPER_TIMEOUT_MS 250

enum pieper_mode { PIEPER_IDLE, PIEPER_ARMED, PIEPER_STOPPED, PIEPER_FAULT };

enum pieper_code {
    PIEPER_NONE, PIEPER_HEARTBEAT_LOST, PIEPER_EMERGENCY_STOP, PIEPER_OUT_OF_RANGE, PIEPER_TOO_FAST,
    PIEPER_STALE, PIEPER_NOT_ARMED, PIEPER_POSITION_LOST, PIEPER_WRONG_COUNT, PIEPER_WRONG_VERSION
};

/* One motor: the ends of its range, and the farthest it goes in a millisecond. */
struct pieper_axis {
    int32_t lower, upper;
    int32_t per_ms;
};

struct pieper_device {
    uint8_t count;
    const struct pieper_axis *axes;
    const char *name;
    void (*send)(uint8_t byte);

    int32_t position[PIEPER_AXES]; /* where the motors are to be now */
    int32_t target[PIEPER_AXES];   /* where they were sent */

    uint8_t mode, code;
    bool greeted, stop_pressed;
    uint32_t session, taken, began, heard, ticked, said;
    uint16_t sequence, last_sequence;

    uint8_t frame[80]; /* what has come since the last zero: no packet to a controller is longer */
    uint8_t length;
};

/* At rest at `position`, or at the end of the range that is nearest. */
void pieper_init(struct pieper_device *device, uint8_t count, const struct pieper_axis *axes, const int32_t *position,
                 const char *name, void (*send)(uint8_t byte));

/* Takes a byte. */
void pieper_receive(struct pieper_device *device, uint8_t byte, uint32_t now_ms);

/* Lets time pass: call it at least once a millisecond or so. */
void pieper_tick(struct pieper_device *device, uint32_t now_ms);

/* The emergency stop: pressed, everything holds; it is armed again only after it was let go. */
void pieper_emergency_stop(struct pieper_device *device, bool pressed);

#endif
