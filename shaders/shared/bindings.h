// Which binding point belongs to whom. Points 0 to 7 of every kind are each pass's own; what many
// passes read lies above, at the same point in all of them.
#ifdef __cplusplus
#pragma once
#endif

// Uniform blocks
#define OFFING_BIND_FRAME 0  // shared/frame.h
#define OFFING_BIND_SKY 1    // shared/sky.h
#define OFFING_BIND_CLOUDS 2  // shared/clouds.h
#define OFFING_BIND_PROBE 3  // shared/probe.h
#define OFFING_BIND_BOAT 4   // shared/boat.h
#define OFFING_BIND_CLOTH 5  // shared/cloth.h

// Texture units
#define OFFING_UNIT_SKY_SUN 8         // sky view of the sun
#define OFFING_UNIT_SKY_MOON 9        // sky view of the moon
#define OFFING_UNIT_TRANSMITTANCE 10  // of the air
#define OFFING_UNIT_MULTISCATTER 11   // of the air
#define OFFING_UNIT_GUSTS 12          // engine/environment/gust_field.h, repeating
#define OFFING_UNIT_PROBE 13          // reflection probe
#define OFFING_UNIT_CLOUD_SHADOW 14   // what clouds leave of the sun
#define OFFING_UNIT_CLOUD_MAP 15      // clouds seen from the boat, for the probe
#define OFFING_UNIT_FOAM 16           // accumulated foam of the sea
