#include "pieper_packets.h"

#include <string.h>

/* CRC-16/IBM-3740: polynomial 0x1021, from 0xFFFF, not reflected. */
static uint16_t crc_of(const uint8_t *bytes, uint8_t count)
{
    uint16_t crc = 0xFFFF;
    while (count--) {
        crc ^= (uint16_t)((uint16_t)*bytes++ << 8);
        for (uint8_t bit = 0; bit < 8; bit++)
            crc = (uint16_t)(crc & 0x8000 ? (crc << 1) ^ 0x1021 : crc << 1);
    }
    return crc;
}

static uint32_t read32(const uint8_t *at)
{
    return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

/* A packet being written. The longest, the capabilities of twelve motors, has 134 bytes. */
struct packet {
    uint8_t bytes[160];
    uint8_t length;
};

static void put8(struct packet *packet, uint8_t value)
{
    packet->bytes[packet->length++] = value;
}

static void put16(struct packet *packet, uint16_t value)
{
    put8(packet, (uint8_t)value);
    put8(packet, (uint8_t)(value >> 8));
}

static void put32(struct packet *packet, uint32_t value)
{
    put16(packet, (uint16_t)value);
    put16(packet, (uint16_t)(value >> 16));
}

static void begin(struct pieper_device *device, struct packet *packet, uint8_t kind)
{
    packet->length = 0;
    put8(packet, PIEPER_VERSION);
    put8(packet, kind);
    put16(packet, device->sequence++);
}

/* Appends the checksum, stuffs the zeros away, and ends with one. */
static void finish(struct pieper_device *device, struct packet *packet)
{
    put16(packet, crc_of(packet->bytes, packet->length));
    uint8_t at = 0;
    for (;;) {
        /* A block: how many bytes there are to the next zero, itself counted, and then those bytes. A packet is shorter than the
         * 254 bytes after which a block would have to end without one. */
        uint8_t end = at;
        while (end < packet->length && packet->bytes[end] != 0)
            end++;
        device->send((uint8_t)(end - at + 1));
        while (at < end)
            device->send(packet->bytes[at++]);
        if (end == packet->length)
            break;
        at = (uint8_t)(end + 1);
    }
    device->send(0);
}

static void refuse(struct pieper_device *device, uint16_t sequence, uint8_t code, uint8_t axis)
{
    struct packet packet;
    begin(device, &packet, 0x83);
    put16(&packet, sequence);
    put8(&packet, code);
    put8(&packet, axis);
    finish(device, &packet);
}

static void tell_capabilities(struct pieper_device *device)
{
    struct packet packet;
    begin(device, &packet, 0x81);
    put8(&packet, PIEPER_VERSION);
    put8(&packet, PIEPER_VERSION);
    put16(&packet, PIEPER_PERIOD_MS);
    put16(&packet, PIEPER_TIMEOUT_MS);
    put8(&packet, 0); /* hobby servos measure nothing */
    put8(&packet, device->count);
    for (uint8_t axis = 0; axis < device->count; axis++) {
        put32(&packet, (uint32_t)device->axes[axis].lower);
        put32(&packet, (uint32_t)device->axes[axis].upper);
    }
    for (const char *letter = device->name; *letter && letter - device->name < 24; letter++)
        put8(&packet, (uint8_t)*letter);
    finish(device, &packet);
}

static void tell_state(struct pieper_device *device, uint32_t now)
{
    struct packet packet;
    begin(device, &packet, 0x82);
    put32(&packet, now);
    put32(&packet, device->session);
    put32(&packet, device->taken);
    put8(&packet, device->mode);
    put8(&packet, device->code);
    put8(&packet, device->count);
    for (uint8_t axis = 0; axis < device->count; axis++)
        put32(&packet, (uint32_t)device->position[axis]);
    finish(device, &packet);
}

/* Holds where the motors are; the session is over. */
static void end_session(struct pieper_device *device, uint8_t mode, uint8_t code)
{
    memcpy(device->target, device->position, sizeof device->target);
    device->mode = mode;
    device->code = code;
    device->session = 0;
}

/* Whether a packet of the session may be taken up: newer than the last, and not late. */
static uint8_t check(struct pieper_device *device, uint16_t sequence, const uint8_t *body, uint32_t now)
{
    uint32_t time = read32(body + 4);
    if (device->mode != PIEPER_ARMED || read32(body) != device->session)
        return PIEPER_NOT_ARMED;
    uint16_t step = (uint16_t)(sequence - device->last_sequence);
    uint32_t here = now - device->began;
    if (step == 0 || step >= 0x8000 || time < device->taken || (here > time && here - time > PIEPER_TIMEOUT_MS))
        return PIEPER_STALE;
    device->last_sequence = sequence;
    device->taken = time;
    device->heard = now;
    return PIEPER_NONE;
}

static void set_point(struct pieper_device *device, uint16_t sequence, const uint8_t *values)
{
    for (uint8_t axis = 0; axis < device->count; axis++) {
        const struct pieper_axis *of = &device->axes[axis];
        int32_t value = (int32_t)read32(values + 4 * axis);
        uint8_t code = PIEPER_NONE;
        if (value < of->lower || value > of->upper) {
            code = PIEPER_OUT_OF_RANGE;
        } else {
            int32_t way = value - device->target[axis];
            if ((way < 0 ? -way : way) / PIEPER_TIMEOUT_MS > of->per_ms)
                code = PIEPER_TOO_FAST;
        }
        if (code != PIEPER_NONE) {
            refuse(device, sequence, code, axis);
            end_session(device, PIEPER_FAULT, code);
            return;
        }
    }
    for (uint8_t axis = 0; axis < device->count; axis++)
        device->target[axis] = (int32_t)read32(values + 4 * axis);
}

/* A packet that passed its check. */
static void hear(struct pieper_device *device, const uint8_t *packet, uint8_t length, uint32_t now)
{
    if (length < 4)
        return;
    uint16_t sequence = (uint16_t)(packet[2] | packet[3] << 8);
    const uint8_t *body = packet + 4;
    uint8_t size = (uint8_t)(length - 4), code;
    if (packet[0] != PIEPER_VERSION) {
        refuse(device, sequence, PIEPER_WRONG_VERSION, 255);
        return;
    }
    switch (packet[1]) {
    case 0x01: /* hello */
        if (size == 0) {
            device->greeted = true;
            tell_capabilities(device);
        }
        break;
    case 0x02: /* arm */
        if (size != 4)
            break;
        if (device->stop_pressed) {
            device->code = PIEPER_EMERGENCY_STOP;
            refuse(device, sequence, PIEPER_EMERGENCY_STOP, 255);
            break;
        }
        end_session(device, PIEPER_ARMED, PIEPER_NONE);
        device->session = read32(body);
        device->began = device->heard = now;
        device->taken = 0;
        device->last_sequence = sequence;
        break;
    case 0x03: /* set-point */
        if (size < 9 || size != 9 + 4 * (uint16_t)body[8])
            break;
        code = check(device, sequence, body, now);
        if (code == PIEPER_NONE && body[8] != device->count)
            code = PIEPER_WRONG_COUNT;
        if (code == PIEPER_NONE)
            set_point(device, sequence, body + 9);
        else if (code != PIEPER_STALE) /* repeated and late ones are nobody's mistake */
            refuse(device, sequence, code, 255);
        break;
    case 0x04: /* heartbeat */
        if (size == 8 && check(device, sequence, body, now) == PIEPER_NOT_ARMED)
            refuse(device, sequence, PIEPER_NOT_ARMED, 255);
        break;
    case 0x05: /* stop */
        if (size == 0)
            end_session(device, PIEPER_STOPPED, PIEPER_NONE);
        break;
    case 0x06: /* disarm */
        if (size == 0)
            end_session(device, PIEPER_IDLE, PIEPER_NONE);
        break;
    default: /* newer programs may say more */
        break;
    }
}

/* Undoes the stuffing in place. The packet's length with its checksum, or 0 where it cannot be undone. */
static uint8_t unstuff(uint8_t *frame, uint8_t length)
{
    uint8_t from = 0, to = 0;
    while (from < length) {
        uint8_t count = frame[from++];
        if (count == 0 || count - 1 > length - from)
            return 0;
        for (uint8_t k = 1; k < count; k++)
            frame[to++] = frame[from++];
        if (from < length)
            frame[to++] = 0;
    }
    return to;
}

void pieper_init(struct pieper_device *device, uint8_t count, const struct pieper_axis *axes, const int32_t *position,
                 const char *name, void (*send)(uint8_t byte))
{
    memset(device, 0, sizeof *device);
    device->count = count < PIEPER_AXES ? count : PIEPER_AXES;
    device->axes = axes;
    device->name = name;
    device->send = send;
    for (uint8_t axis = 0; axis < device->count; axis++) {
        int32_t value = position[axis];
        if (value < axes[axis].lower)
            value = axes[axis].lower;
        if (value > axes[axis].upper)
            value = axes[axis].upper;
        device->position[axis] = device->target[axis] = value;
    }
}

void pieper_receive(struct pieper_device *device, uint8_t byte, uint32_t now)
{
    if (byte != 0) {
        /* A length past the buffer marks what is too long: it is dropped at its end. */
        if (device->length < sizeof device->frame)
            device->frame[device->length] = byte;
        if (device->length <= sizeof device->frame)
            device->length++;
        return;
    }
    uint8_t length = device->length;
    device->length = 0;
    if (length == 0 || length > sizeof device->frame)
        return;
    length = unstuff(device->frame, length);
    if (length < 2)
        return;
    uint16_t sum = (uint16_t)(device->frame[length - 2] | device->frame[length - 1] << 8);
    if (crc_of(device->frame, (uint8_t)(length - 2)) == sum)
        hear(device, device->frame, (uint8_t)(length - 2), now);
}

void pieper_tick(struct pieper_device *device, uint32_t now)
{
    uint32_t passed = now - device->ticked;
    device->ticked = now;
    if (device->mode == PIEPER_ARMED && now - device->heard > PIEPER_TIMEOUT_MS)
        end_session(device, PIEPER_FAULT, PIEPER_HEARTBEAT_LOST);
    if (passed > PIEPER_TIMEOUT_MS)
        passed = PIEPER_TIMEOUT_MS;
    for (uint8_t axis = 0; axis < device->count && !device->stop_pressed; axis++) {
        int32_t most = device->axes[axis].per_ms * (int32_t)passed;
        int32_t way = device->target[axis] - device->position[axis];
        if (way > most)
            way = most;
        if (way < -most)
            way = -most;
        device->position[axis] += way;
    }
    if (device->greeted && now - device->said >= PIEPER_PERIOD_MS) {
        device->said = now;
        tell_state(device, now);
    }
}

void pieper_emergency_stop(struct pieper_device *device, bool pressed)
{
    if (pressed && !device->stop_pressed)
        end_session(device, PIEPER_FAULT, PIEPER_EMERGENCY_STOP);
    device->stop_pressed = pressed;
}
