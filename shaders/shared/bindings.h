// Which binding point belongs to whom. Uniform blocks have one each; texture units, images and
// storage buffers 0 to 7 are each pass's own, and what many passes read lies above, at the same point
// in all of them.
#ifdef __cplusplus
#pragma once
#endif

// Uniform blocks
#define OFFING_BIND_FRAME 0       // shared/frame.h
#define OFFING_BIND_SKY 1         // shared/sky.h
#define OFFING_BIND_CLOUDS 2      // shared/clouds.h
#define OFFING_BIND_PROBE 3       // shared/probe.h
#define OFFING_BIND_OCEAN 4       // shared/ocean.h
#define OFFING_BIND_UNDERWATER 5  // shared/underwater.h
#define OFFING_BIND_BOAT 6        // shared/boat.h
#define OFFING_BIND_CLOTH 7       // shared/cloth.h
#define OFFING_BIND_GARDNER 8     // shared/gardner.h
#define OFFING_BIND_FOAM 9        // shared/ocean.h: a step of the foam map
#define OFFING_BIND_BOAT_SHADOW 10  // shared/boat_shadow.h

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
#define OFFING_UNIT_CLOUD_SHAPE 17    // body of the clouds: noise, repeating (3-D)
#define OFFING_UNIT_CLOUD_DETAIL 18   // their edges, likewise
#define OFFING_UNIT_CLOUD_CURL 19     // what the wind does to their edges
#define OFFING_UNIT_CLOUD_WEATHER 20  // where there are clouds, and which
#define OFFING_UNIT_CLOUD_MOST 21     // the most of it round each of its coarse cells
#define OFFING_UNIT_SEA_ROUGHNESS 22    // what the sea's maps do not show
#define OFFING_UNIT_SQUALLS 23        // engine/environment/squall_field.h, repeating
#define OFFING_UNIT_BOAT_SHADOW 24    // boat/shadow.glsl
#define OFFING_UNIT_FOAM_LACE 25      // pictures of foam, repeating: engine/ocean/foam_pattern.h
#define OFFING_UNIT_FOAM_ROWS 26
