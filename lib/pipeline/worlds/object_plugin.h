/* SPDX-License-Identifier: MIT */
/* The interface between programs and object plug-ins, in C: all that the two sides share. */
#ifndef L3D_PIPELINE_WORLDS_OBJECT_PLUGIN_H
#define L3D_PIPELINE_WORLDS_OBJECT_PLUGIN_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The version of the interface. It goes up when a plug-in made for the old one would no longer
   work. Members added at the end of a structure do not change it: `size` tells their number. */
#define L3D_PLUGIN_VERSION 1u

/** An object of the program's world, as plug-ins see it: by the functions below alone. */
typedef struct l3d_plugin_object l3d_plugin_object;

/** The functions that a program offers to plug-ins. A plug-in may call them only from within
   its own functions; they copy what they are given. Those that return an int return 1 for
   success. They return 0 if an argument is not right; the program reports that, and the
   plug-in has only to return. Numbers have to be finite, and in the range of the program's own:
   below 2^31 where it is built for fixed point, 2^128 for float. */
typedef struct l3d_plugin_host {
    uint32_t size;    /**< of this structure, in bytes */
    uint32_t version; /**< L3D_PLUGIN_VERSION */

    /** Replaces the object's polygons. `coordinates` has three numbers for each vertex. Face i has
       corner_counts[i] >= 3 corners. `corners` has the vertices of one face after the other,
       clockwise from outside; axes are left-handed. `colors` has a word 0x00RRGGBB for each face.
     */
    int (*set_polygons)(l3d_plugin_object* object, uint32_t vertices, const double* coordinates,
                        uint32_t faces, const uint32_t* corner_counts, const uint32_t* corners,
                        const uint32_t* colors);

    /** Replaces the polygons by those of a Videoscape file, made left-handed. The program looks for
       relative names where it was told to. Faces get random colours if `random_colors` is not 0. */
    int (*load_videoscape)(l3d_plugin_object* object, const char* file, int random_colors);

    /** Sets matrix `index` of the object's placement, row by row; a point is a column. Matrix 0
       is applied first. index < 16. */
    int (*set_transform)(l3d_plugin_object* object, uint32_t index, const double matrix[16]);

    /** 32 random bits, the same in every run from the same seed. */
    uint32_t (*random)(l3d_plugin_object* object);

    /** Says why create or copy is about to return a null pointer. */
    void (*fail)(l3d_plugin_object* object, const char* why);

    /** Replaces the polygons by those of a model file of any format that the program reads, made
       left-handed with y up; patches become polygons. Files are looked for as by load_videoscape.
       If `random_colors` is not 0, faces get random colours where the file gives them none, and in
       Videoscape files always. This member and those that follow are only there if
       `size` reaches beyond them. */
    int (*load_model)(l3d_plugin_object* object, const char* file, int random_colors);

    /** Names the object, for the program's messages. */
    int (*set_name)(l3d_plugin_object* object, const char* name);
} l3d_plugin_host;

/** A plug-in is a shared library that defines one of these by the name l3d_plugin. */
typedef struct l3d_plugin_interface {
    uint32_t size;    /**< of this structure, in bytes */
    uint32_t version; /**< L3D_PLUGIN_VERSION */

    /** Sets the object up. The result is the plug-in's own data for this object, which the other
       functions get; null if it cannot be done. The host outlives the data; `parameters` do not. */
    void* (*create)(const l3d_plugin_host* host, l3d_plugin_object* object, const char* parameters);
    /** Lets time pass. */
    void (*update)(void* data, double seconds);
    /** Makes the data for a copy of the object, whose polygons and placement have been copied
       already; null if it cannot be done. */
    void* (*copy)(const void* data, l3d_plugin_object* copied);
    /** Frees what create or copy made. Called before the object goes. */
    void (*destroy)(void* data);
} l3d_plugin_interface;

/** The name that a plug-in's interface has in its library. */
#define L3D_PLUGIN_SYMBOL "l3d_plugin"

#ifdef __cplusplus
}
#endif

#endif
