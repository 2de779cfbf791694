/* SPDX-License-Identifier: MIT */
/* The interface between programs and object plug-ins, in C: all that the two sides share. */
#ifndef L3D_PIPELINE_WORLDS_OBJECT_PLUGIN_H
#define L3D_PIPELINE_WORLDS_OBJECT_PLUGIN_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The version of the interface. It goes up when plug-ins made for the old version would no longer
   work. New members at the end of a structure do not change the version: `size` tells whether they
   are there. */
#define L3D_PLUGIN_VERSION 1u

/** An object of the program's world. Plug-ins see it only through the functions below. */
typedef struct l3d_plugin_object l3d_plugin_object;

/** The functions that a program offers to plug-ins. A plug-in may call them only while one of
   its own functions runs. They copy their arguments. Functions that return an int return 1 for
   success, and 0 if an argument is wrong. In this case the program reports the fault, and the
   plug-in need only return. Numbers must be finite, and in the range of the program's own numbers:
   below 2^31 if the program is built for fixed point, below 2^128 for float. */
typedef struct l3d_plugin_host {
    uint32_t size;    /**< size of this structure, in bytes */
    uint32_t version; /**< L3D_PLUGIN_VERSION of the program */

    /** Replaces the object's polygons. `coordinates` has three numbers for each vertex. Face i has
       corner_counts[i] >= 3 corners. `corners` has the vertices of one face after the other,
       clockwise from outside; axes are left-handed. `colors` has a word 0x00RRGGBB for each face.
     */
    int (*set_polygons)(l3d_plugin_object* object, uint32_t vertices, const double* coordinates,
                        uint32_t faces, const uint32_t* corner_counts, const uint32_t* corners,
                        const uint32_t* colors);

    /** Replaces the object's polygons by those of a Videoscape file, made left-handed. A relative
       name is looked for in the folder that the program has set. Faces get random colours if
       `random_colors` is not 0. */
    int (*load_videoscape)(l3d_plugin_object* object, const char* file, int random_colors);

    /** Sets matrix `index` of the object's placement; `index` is less than 16. `matrix` has the
       numbers row by row, and is multiplied by a point as a column. Matrix 0 is applied first. */
    int (*set_transform)(l3d_plugin_object* object, uint32_t index, const double matrix[16]);

    /** Returns 32 random bits, the same in every run from the same seed. */
    uint32_t (*random)(l3d_plugin_object* object);

    /** Tells the program why create or copy will return a null pointer. */
    void (*fail)(l3d_plugin_object* object, const char* why);

    /** Replaces the object's polygons by those of a model file of any format that the program
       reads, made left-handed with y up; patches become polygons. A relative name is looked for as
       by load_videoscape. If `random_colors` is not 0, faces get random colours if the file gives
       no colours, and always for Videoscape files. This member and the next ones are there only
       if `size` reaches beyond them. */
    int (*load_model)(l3d_plugin_object* object, const char* file, int random_colors);

    /** Gives the object a name, for the program's messages. */
    int (*set_name)(l3d_plugin_object* object, const char* name);
} l3d_plugin_host;

/** The functions of a plug-in. A plug-in is a shared library that defines an object of this type
   with the name l3d_plugin. */
typedef struct l3d_plugin_interface {
    uint32_t size;    /**< size of this structure, in bytes */
    uint32_t version; /**< L3D_PLUGIN_VERSION that the plug-in was made for */

    /** Sets an object up. The result is the plug-in's own data for this object, which the other
       functions get; null if the object cannot be set up. `host` outlives the data; `parameters`
       live only during the call. */
    void* (*create)(const l3d_plugin_host* host, l3d_plugin_object* object, const char* parameters);
    /** Lets `seconds` pass for the object of these data. */
    void (*update)(void* data, double seconds);
    /** Makes data for `copied`, a copy of the object of `data`. The polygons and the placement have
       been copied already. The result is null if no data can be made. */
    void* (*copy)(const void* data, l3d_plugin_object* copied);
    /** Frees the data that create or copy made. Called before the object is destroyed. */
    void (*destroy)(void* data);
} l3d_plugin_interface;

/** The name that a plug-in's interface has in its library. */
#define L3D_PLUGIN_SYMBOL "l3d_plugin"

#ifdef __cplusplus
}
#endif

#endif
