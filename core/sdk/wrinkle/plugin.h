/* wrinkle/plugin.h: the contract between Wrinkle and a node author, in C. Version 1, frozen.
 *
 * A plugin is a shared object that exports one symbol, wrinkle_plugin(), and describes nodes. A
 * node is a pure function over expression values: its build() receives a builder and records
 * instructions of the language below. That happens while a graph is lowered and never during
 * preview or evaluation, so a plugin's speed never matters at run time and the host keeps nothing
 * of it afterwards.
 *
 * Ownership  Nothing is handed over: neither side frees what the other made. Every call below says
 *            how long its arguments and its result live. Descriptors and their strings are static
 *            data of the plugin, unchanged while it is loaded; the host copies what it keeps.
 * Threads    Every call is marked with where it may be made:
 *              [load]   by the host, from one thread at a time, before any build() of the plugin;
 *                       it may be repeated, also in another process that only reads descriptors
 *              [build]  during a build(), on the thread that called it
 *            Several builds may run at once on several threads, each with a builder of its own, of
 *            one node too. So build() keeps no state; a constant table is not state.
 * Errors     A call that makes no sense records a diagnostic on the node and returns WR_POISON.
 *            Poison passes through every operation silently, so a body needs no checks.
 *            Exceptions must not leave build(); the C++ face sees to that. The host throws none.
 * Versions   WR_ABI changes only with a contract that is another one; a host takes its own alone.
 *            Within it every struct begins with its size and only grows at its end, so a plugin
 *            runs in hosts younger and older than itself. `size` is what its maker's header says
 *            (sizeof). A reader looks at a member only where `size` covers it; all members that
 *            stand here are covered always. Numbers of types, ops, inputs and kinds are
 *            append-only: an op that the host does not know is a diagnostic. Anything optional goes
 *            through get_extension.
 * Only fixed-width integers, double, pointers and function pointers cross; strings are UTF-8, end
 * with 0 and have one line: names at most 64 bytes, other texts 4096.
 *
 * Values of the language
 *   float vec2 vec3 vec4 mat3 int uint bool      as in GLSL; mat3 is column-major
 *   gradient    a surface gradient: the change of a height along the surface as a tangent vector,
 *               with the base it refers to
 *   frame       what turns a slope in a uv set into a gradient
 *   derivative  dh/d(u,v), a 2-vector, together with its frame
 *   base        the normal that gradients refer to: the surface's, or the output of one resolve
 *   material    a record of channels, such as color, roughness and a bump: an open set of names,
 *               each with a value of one port type
 *
 * Semantics at the corners, to which every back end is held
 *   - Operands are evaluated eagerly; `select` takes one of two values already computed and never
 *     mixes them.
 *   - float is IEEE single in shaders and on the CPU; folding of constants happens in double. x*0
 *     folds to 0 (a NaN or an infinity in x is discarded), x+0 to x, x*1 to x, x-x to 0, 0/x to 0,
 *     mix(a,a,t) to a, dot with 0 to 0.
 *   - min(a,b) is b < a ? b : a; max(a,b) is a < b ? b : a; clamp(x,lo,hi) is min(max(x,lo),hi).
 *   - mod is floor-mod: x - y*floor(x/y). sign(0) is 0; sign_nonzero is +1 for x >= 0 and -1
 *     below.
 *   - step(edge,x) is x < edge ? 0 : 1. smoothstep(a,b,x) with a >= b is unspecified.
 *   - Undefined at: division by 0; sqrt, log, log2 of x < 0; inversesqrt of x <= 0; pow of x < 0
 *     or of (0, y <= 0); asin, acos outside [-1,1]; normalize of a zero vector; atan2(0,0). An op
 *     may give anything there. The C++ face's functions of the same names guard these (sqrt of a
 *     negative is 0, normalize of zero is zero, and so on); a plugin in C guards for itself.
 *   - int and uint are 32 bits and wrap; a shift amount is 0..31. to_int and to_uint truncate
 *     towards zero; a value that does not fit is unspecified. Comparisons with NaN are false but
 *     for `ne`.
 * Derivatives (forward, along a direction of the surface): the derivative of every op is derived
 *   by the host. floor, ceil, step, sign, comparisons, integers and `detach` have derivative 0;
 *   select takes the chosen branch's; at the singular points of sqrt, length, normalize, pow,
 *   asin, acos and abs the derivative is 0. */
#ifndef WRINKLE_PLUGIN_H
#define WRINKLE_PLUGIN_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define WR_ABI 1u /* major version: plugin and host must agree */

#if defined(__GNUC__)
#define WR_EXPORT __attribute__((visibility("default")))
#else
#define WR_EXPORT
#endif

/* clang-format off */

/* Types of values: X(name, number, GLSL spelling, lanes) */
#define WR_TYPES(X) \
    X(poison,     0,  "",      0) \
    X(float,      1,  "float", 1) \
    X(vec2,       2,  "vec2",  2) \
    X(vec3,       3,  "vec3",  3) \
    X(vec4,       4,  "vec4",  4) \
    X(mat3,       5,  "mat3",  9) \
    X(int,        6,  "int",   1) \
    X(uint,       7,  "uint",  1) \
    X(bool,       8,  "bool",  1) \
    X(gradient,   9,  "",      0) \
    X(frame,      10, "",      0) \
    X(derivative, 11, "",      0) \
    X(base,       12, "",      0) \
    X(tuple,      13, "",      0) \
    X(material,   14, "",      0)

/* What stands on wires: X(name, number, type of its value). An image has no value, only a
 * handle. */
#define WR_PORT_TYPES(X) \
    X(float,      1,  float) \
    X(vec2,       2,  vec2) \
    X(vec3,       3,  vec3) \
    X(vec4,       4,  vec4) \
    X(color,      5,  vec3) \
    X(height,     6,  float) \
    X(derivative, 7,  derivative) \
    X(gradient,   8,  gradient) \
    X(normal,     9,  vec3) \
    X(image,      10, poison) \
    X(material,   11, material)

/* Properties of the surface point, all in object space: X(name, number, type, doc) */
#define WR_SURFACE_INPUTS(X) \
    X(position, 0,  vec3,  "Position in object space, in length units") \
    X(normal,   1,  vec3,  "Interpolated normal, unit, object space") \
    X(tangent,  2,  vec4,  "Vertex tangent of uv0; w is the sign of the bitangent") \
    X(uv0,      3,  vec2,  "First uv set, origin at the bottom left") \
    X(uv1,      4,  vec2,  "Second uv set") \
    X(uv2,      5,  vec2,  "Third uv set") \
    X(uv3,      6,  vec2,  "Fourth uv set") \
    X(color0,   7,  vec4,  "Vertex colour, linear") \
    X(view,     8,  vec3,  "Unit vector towards the eye, object space") \
    X(facing,   9,  float, "+1 on front faces, -1 on back faces")

/* For surface() alone: the unit normal before the graph's back-face rule turns it */
#define WR_SURFACE_FRONT_NORMAL 64u

/* How arguments and result of an op relate; what breaks its rule is a diagnostic and poison.
 *   leaf       made by the host, never emitted
 *   same       all of one float or integer type, the result too
 *   broadcast  as same, and a float may stand beside a vector; the result is the wider
 *   floats     as broadcast, float types only
 *   compare    two scalars of one type -> bool
 *   logic      bool... -> bool
 *   bits       int or uint, the result the same
 *   special    its own rule, said in the comment at its row */

/* Flags: commutative; opaque (expanded by the host before any back end); implicit derivatives
 * (illegal in regions); zero derivative */
#define WR_FLAG_COMMUTATIVE 1u
#define WR_FLAG_OPAQUE 2u
#define WR_FLAG_IMPLICIT 4u
#define WR_FLAG_ZERO_DERIVATIVE 8u

/* The one op table:
 *   X(name, number, arity (-1: 1 to 4), rule, GLSL spelling, GLSL precedence, flags)
 * Precedence: 17 postfix, 16 prefix, 15 * /, 14 + -, 13 shifts, 12 relational, 11 equality, 10 &,
 * 9 ^, 8 |, 7 &&, 5 ||, 3 ?:, 0 call syntax. */
#define WR_OPS(X) \
    X(poison,         0,   0, leaf,      "",            0,  0) \
    X(literal,        1,   0, leaf,      "",            0,  8) /* one scalar */ \
    /* a surface input, or its change along screen x or y */ \
    X(input,          2,   0, leaf,      "",            0,  0) \
    /* a number that the user may change */ \
    X(parameter,      3,   0, leaf,      "",            0,  8) \
    X(region_param,   4,   0, leaf,      "",            0,  0) /* of the region at this level */ \
    /* 1-4 floats or vectors -> vecN of as many lanes; 3 vec3 columns -> mat3 */ \
    X(construct,      10, -1, special,   "",            0,  0) \
    X(swizzle,        11,  1, special,   "",            17, 0) /* extra: WR_SWIZZLE */ \
    X(column,         12,  1, special,   "",            17, 0) /* mat3 -> vec3; extra: which */ \
    X(neg,            20,  1, same,      "-",           16, 0) \
    X(add,            21,  2, broadcast, "+",           14, 1) \
    X(sub,            22,  2, broadcast, "-",           14, 0) \
    X(mul,            23,  2, broadcast, "*",           15, 1) \
    X(div,            24,  2, floats,    "/",           15, 0) \
    X(mod,            25,  2, floats,    "mod",         0,  0) \
    X(abs,            26,  1, floats,    "abs",         0,  0) \
    X(sign,           27,  1, floats,    "sign",        0,  8) \
    X(floor,          28,  1, floats,    "floor",       0,  8) \
    X(ceil,           29,  1, floats,    "ceil",        0,  8) \
    X(fract,          30,  1, floats,    "fract",       0,  0) \
    X(min,            31,  2, broadcast, "min",         0,  0) \
    X(max,            32,  2, broadcast, "max",         0,  0) \
    X(clamp,          33,  3, floats,    "clamp",       0,  0) \
    X(mix,            34,  3, floats,    "mix",         0,  0) \
    X(step,           35,  2, floats,    "step",        0,  8) \
    X(smoothstep,     36,  3, floats,    "smoothstep",  0,  0) \
    X(sign_nonzero,   37,  1, special,   "",            3,  8) /* float -> float */ \
    X(sqrt,           40,  1, floats,    "sqrt",        0,  0) \
    X(inversesqrt,    41,  1, floats,    "inversesqrt", 0,  0) \
    X(pow,            42,  2, floats,    "pow",         0,  0) \
    X(exp,            43,  1, floats,    "exp",         0,  0) \
    X(log,            44,  1, floats,    "log",         0,  0) \
    X(exp2,           45,  1, floats,    "exp2",        0,  0) \
    X(log2,           46,  1, floats,    "log2",        0,  0) \
    X(sin,            47,  1, floats,    "sin",         0,  0) \
    X(cos,            48,  1, floats,    "cos",         0,  0) \
    X(tan,            49,  1, floats,    "tan",         0,  0) \
    X(asin,           50,  1, floats,    "asin",        0,  0) \
    X(acos,           51,  1, floats,    "acos",        0,  0) \
    X(atan,           52,  1, floats,    "atan",        0,  0) \
    X(atan2,          53,  2, floats,    "atan",        0,  0) /* (y, x) */ \
    /* two vectors of one type -> float */ \
    X(dot,            60,  2, special,   "dot",         0,  1) \
    X(cross,          61,  2, special,   "cross",       0,  0) /* vec3, vec3 -> vec3 */ \
    X(length,         62,  1, special,   "length",      0,  0) /* vector -> float */ \
    X(normalize,      63,  1, special,   "normalize",   0,  0) /* vector -> same */ \
    X(reflect,        64,  2, special,   "reflect",     0,  0) /* vector, unit normal -> same */ \
    X(transform,      65,  2, special,   "*",           15, 0) /* mat3, vec3 -> vec3 */ \
    X(matrix_product, 66,  2, special,   "*",           15, 0) /* mat3, mat3 -> mat3 */ \
    X(transpose,      67,  1, special,   "transpose",   0,  0) /* mat3 -> mat3 */ \
    X(lt,             70,  2, compare,   "<",           12, 8) \
    X(le,             71,  2, compare,   "<=",          12, 8) \
    X(gt,             72,  2, compare,   ">",           12, 8) \
    X(ge,             73,  2, compare,   ">=",          12, 8) \
    X(eq,             74,  2, compare,   "==",          11, 9) \
    X(ne,             75,  2, compare,   "!=",          11, 9) \
    X(and,            76,  2, logic,     "&&",          7,  9) \
    X(or,             77,  2, logic,     "||",          5,  9) \
    X(not,            78,  1, logic,     "!",           16, 8) \
    X(select,         79,  3, special,   "?:",          3,  0) /* bool, T, T -> T */ \
    X(bit_and,        80,  2, bits,      "&",           10, 9) \
    X(bit_or,         81,  2, bits,      "|",           8,  9) \
    X(bit_xor,        82,  2, bits,      "^",           9,  9) \
    X(shift_left,     83,  2, bits,      "<<",          13, 8) \
    /* arithmetic for int, logical for uint */ \
    X(shift_right,    84,  2, bits,      ">>",          13, 8) \
    X(to_float,       85,  1, special,   "float",       0,  8) /* int, uint or bool -> float */ \
    X(to_int,         86,  1, special,   "int",         0,  8) /* float or uint -> int */ \
    /* int -> uint; a float goes through to_int */ \
    X(to_uint,        87,  1, special,   "uint",        0,  8) \
    /* any number -> the same with zero derivative */ \
    X(detach,         90,  1, special,   "",            0,  8) \
    /* ddx, ddy: float types; the change to the next pixel in x, in y */ \
    X(ddx,            91,  1, special,   "",            0,  10) \
    X(ddy,            92,  1, special,   "",            0,  10) \
    /* vec2, vec3 of covariances (xx, yy, xy); or vec3, float variance of each lane: the value \
     * itself, which varies so within a pixel. Zero, or a second one on it, adds nothing. */ \
    X(with_covariance, 93, 2, special,   "",            0,  2) \
    /* vec2 uv -> vec4; extra: resource */ \
    X(sample,         100, 1, special,   "texture",     0,  4) \
    X(sample_lod,     101, 2, special,   "textureLod",  0,  0) /* uv, float lod -> vec4 */ \
    X(sample_grad,    102, 3, special,   "textureGrad", 0,  0) /* uv, duv/dx, duv/dy -> vec4 */ \
    /* -> vec2, texels of level 0; extra: resource */ \
    X(image_size,     103, 0, special,   "textureSize", 0,  8) \
    /* initial state -> tuple; extra: region */ \
    X(loop,           110, -1, special,  "",            0,  0) \
    /* arguments -> tuple; extra: region */ \
    X(call,           111, -1, special,  "",            0,  0) \
    /* tuple -> its member number extra */ \
    X(result,         112, 1, special,   "",            0,  0) \
    /* vec3: the surface's normal or the value of a resolve */ \
    X(base,           120, 1, special,   "",            0,  2) \
    /* vec2 uv [, vec3 direction for guess]; extra: WR_FRAME */ \
    X(frame,          121, -1, special,  "",            0,  2) \
    X(derivative,     122, 2, special,   "",            0,  2) /* vec2 dh/d(u,v), frame */ \
    /* vec3 tangent-space normal, float strength, frame -> derivative */ \
    X(normal_derivative, 123, 3, special, "",           0,  2) \
    /* derivative -> its vec2 dh/d(u,v) */ \
    X(slope,          124, 1, special,   "",            0,  2) \
    X(gradient_zero,            130, 0, special, "",    0,  2) /* flat, on any base */ \
    /* gradient_from_*: extra: a base, or 0 for that of the node's inputs. This one: derivative */ \
    X(gradient_from_derivative, 131, 1, special, "",    0,  2) \
    /* float: object-space length, positive outward */ \
    X(gradient_from_height,     132, 1, special, "",    0,  2) \
    /* vec3: grad of a height over space */ \
    X(gradient_from_volume,     133, 1, special, "",    0,  2) \
    /* vec3 perturbed normal, any length */ \
    X(gradient_from_normal,     134, 1, special, "",    0,  2) \
    X(gradient_add,             135, 2, special, "",    0,  3) \
    X(gradient_scale,           136, 2, special, "",    0,  2) /* gradient, float */ \
    /* gradient, gradient, float: (1-t) a + t b */ \
    X(gradient_mix,             137, 3, special, "",    0,  2) \
    /* gradient -> vec3, object space, tangent to its base */ \
    X(gradient_vector,          138, 1, special, "",    0,  2) \
    /* gradient -> vec3 unit normal, object space */ \
    X(resolve,                  139, 1, special, "",    0,  2) \
    /* as from_normal; one that points inward is reversed */ \
    X(gradient_from_outward_normal, 140, 1, special, "", 0, 2) \
    /* gradient -> float: the trace of the covariance of its unit normal within a pixel, from the \
     * images that its slopes are read from and from with_covariance */ \
    X(normal_variance,          141, 1, special, "",    0,  2) \
    /* a record of channels; extra: the host's own number of it */ \
    X(material,                 142, 0, leaf,    "",    0,  2) \
    /* gradient, vec3 x across its unit normal n -> vec3: that covariance along x and cross(n, x), \
     * both of length 1: (xx, yy, xy) */ \
    X(normal_covariance,        143, 2, special, "",    0,  2)

/* Methods of a frame, and the scale that goes with them (reference: Mikkelsen 2020 and 2010):
 * X(name, number) */
#define WR_FRAME_METHODS(X) \
    /* exact where the scale is surface; else vertex for functions of uv0, else derived */ \
    X(auto,    0) \
    X(vertex,  1) /* MikkTSpace: the vertex tangent of uv0 */ \
    X(derived, 2) /* orthonormal, from the uv's own differentials */ \
    X(exact,   3) /* inverse transpose of the uv's differentials: keeps stretch and skew */ \
    X(guess,   4) /* tangent = a given direction */ \
    X(pixel,   5) /* slopes are the changes to the next pixels in x and y themselves */
#define WR_SCALES(X) \
    X(surface, 0) /* heights are lengths of object space */ \
    X(unit,    1) /* slopes are dh/d(uv) in an orthonormal frame, independent of size */

/* clang-format on */

enum {
#define X(name, number, glsl, lanes) WR_TYPE_##name = number,
    WR_TYPES(X)
#undef X
};
enum {
#define X(name, number, type) WR_PORT_##name = number,
    WR_PORT_TYPES(X)
#undef X
};
enum {
#define X(name, number, type, doc) WR_SURFACE_##name = number,
    WR_SURFACE_INPUTS(X)
#undef X
};
enum {
#define X(name, number, arity, rule, glsl, precedence, flags) WR_OP_##name = number,
    WR_OPS(X)
#undef X
};
enum {
#define X(name, number) WR_FRAME_##name = number,
    WR_FRAME_METHODS(X)
#undef X
};
enum {
#define X(name, number) WR_SCALE_##name = number,
    WR_SCALES(X)
#undef X
};

/* `extra` of a frame, and of a swizzle (count 1-4 of components 0-3; unused ones 0) */
#define WR_FRAME(method, scale) ((uint32_t)(method) | (uint32_t)(scale) << 8)
#define WR_SWIZZLE(count, a, b, c, d)                                                    \
    ((uint32_t)(count) | (uint32_t)(a) << 4 | (uint32_t)(b) << 8 | (uint32_t)(c) << 12 | \
     (uint32_t)(d) << 16)

/* Numbers that the host gives during one build() and that mean nothing after it. */
typedef uint32_t wr_value;  /* 0 is poison */
typedef uint32_t wr_image;  /* an image of this graph; 0 is none */
typedef uint32_t wr_region; /* a loop body or a function; 0 is none */
#define WR_POISON 0u

/* Kinds of regions */
#define WR_REGION_FUNCTION 1u /* results: the outputs; captured values become parameters */
#define WR_REGION_LOOP 2u /* parameters: the state; results: bool "continue", then the next state */

/* What a node's build() works with. Made and owned by the host, valid during that build(). Members
 * are called as b->emit(b, ...), all of them [build]. Arrays and strings that they are given are
 * copied before they return; an array that receives values belongs to the caller. `port` is an
 * index into wr_node.ports, outputs counted too. */
typedef struct wr_builder {
    uint32_t size;
    void* host; /* the host's own */

    /* The value at a port: of its wire, its literal, or its default. A number, gradient or
     * derivative; in a region too. */
    wr_value (*input)(const struct wr_builder* b, uint32_t port);
    /* The image at a port; 0 when none is given (a diagnostic is recorded). */
    wr_image (*image)(const struct wr_builder* b, uint32_t port);
    /* A choice's index, a count's value or a flag's 0 or 1, known now: C code may branch on it. */
    int32_t (*option)(const struct wr_builder* b, uint32_t port);
    /* The expression at a field port, read where its domain (the port's surface input) equals
     * `at`, which is of the domain's type. */
    wr_value (*field)(const struct wr_builder* b, uint32_t port, wr_value at);

    /* A finite number of 1-4 lanes (float, vec, int, uint, bool), or a mat3 of 9, by columns. */
    wr_value (*literal)(const struct wr_builder* b, uint32_t type, const double* lanes);
    /* A property of the surface, WR_SURFACE_*. The normal is unit and follows the graph's back-face
     * rule. */
    wr_value (*surface)(const struct wr_builder* b, uint32_t input);
    /* One op of the table but loop, call, result and those that sample. `type` matters for
     * construct only (the type to make), `extra` where the op's row says so; both are 0 else. */
    wr_value (*emit)(const struct wr_builder* b, uint32_t op, uint32_t type, const wr_value* args,
                     uint32_t count, uint32_t extra);
    /* sample, sample_lod or sample_grad of an image, decoded by its encoding; image_size too.
     * Inside a region, `sample` becomes sample_grad with the uv's differentials from outside. */
    wr_value (*sample)(const struct wr_builder* b, uint32_t op, wr_image image,
                       const wr_value* args, uint32_t count);

    /* Between begin and end, what is recorded is the region's body, and its values are of no use
     * outside; regions may stand in regions, and each has one end. `types` are 1 to 64 numbers,
     * `params` receives as many values. `name` is what a function is called in generated text.
     * end_region takes the results and, for a loop, the greatest number of iterations, at most
     * 65536; 0 when the region is of no use (a diagnostic is recorded). */
    void (*begin_region)(const struct wr_builder* b, uint32_t kind, const char* name,
                         const uint32_t* types, uint32_t count, wr_value* params);
    wr_region (*end_region)(const struct wr_builder* b, const wr_value* results, uint32_t count,
                            uint32_t max_iterations);
    /* Calls a function, or runs a loop from an initial state; `results` receives its outputs. */
    void (*apply)(const struct wr_builder* b, wr_region region, const wr_value* args,
                  uint32_t count, wr_value* results, uint32_t result_count);

    /* The value of an output, once for each; of an image output, a wr_image. */
    void (*output)(const struct wr_builder* b, uint32_t port, wr_value value);
    /* A problem on the node, in a sentence for the user of the graph. build() may go on. */
    void (*error)(const struct wr_builder* b, const char* message);
    /* A struct of the extension "name/1", valid as long as the builder; null when the host has
     * none of this id. */
    const void* (*get_extension)(const struct wr_builder* b, const char* id);
    /* What a value is called in generated text, where it becomes a line of its own. With
     * "pi // half a turn", it is a named constant with a comment, if it is a literal. */
    void (*name)(const struct wr_builder* b, wr_value value, const char* name);

    /* Members from here on are younger than version 1's first header: `size` covers them or not.
     * The value of a material's channel; `type` is its WR_PORT_*, a gradient for a bump. A channel
     * that the material does not have is the default of the standard output of that name, or 0. */
    wr_value (*channel)(const struct wr_builder* b, wr_value material, const char* name,
                        uint32_t type);
    /* The material with this channel set; unchanged if `value` is WR_POISON. The
     * material WR_POISON has no channels. */
    wr_value (*with_channel)(const struct wr_builder* b, wr_value material, const char* name,
                             uint32_t type, wr_value value);
    /* All channels of both, each (1-t) a + t b, gradients as gradient_mix; `t` is a float. */
    wr_value (*mix_materials)(const struct wr_builder* b, wr_value one, wr_value other, wr_value t);
} wr_builder;

/* Kinds of ports */
#define WR_KIND_INPUT 1u /* a value: wire, literal or default */
#define WR_KIND_OUTPUT 2u
#define WR_KIND_CHOICE 3u /* one of several names, known while building */
#define WR_KIND_COUNT 4u  /* an integer, known while building */
#define WR_KIND_FLAG 5u   /* a bool, known while building */
#define WR_KIND_FIELD 6u  /* an expression that build() may read at other places */

/* Where an unconnected input's value comes from */
#define WR_DEFAULT_NONE 0u     /* required (images, gradients and derivatives: flat) */
#define WR_DEFAULT_CONSTANT 1u /* default_value */
#define WR_DEFAULT_SURFACE 2u  /* the property default_surface */
#define WR_DEFAULT_ABSENT 3u   /* WR_POISON, for with_channel(); default_value is shown */

/* All descriptors below are the plugin's, static, and read by the host after wrinkle_plugin() has
 * returned. What is said to be null or 0 where it does not apply must be so. */
typedef struct wr_port {
    uint32_t size;
    uint32_t kind;    /* WR_KIND_* */
    uint32_t type;    /* WR_PORT_* of inputs, outputs and fields */
    const char* name; /* lower_snake_case; unique among outputs, and among all others */
    const char* doc;  /* one line, with the unit in words */
    const char* unit; /* "m", "deg", "x" or ""; null is "" */
    uint32_t default_kind;
    uint32_t default_surface;   /* WR_SURFACE_*: the default, or a field's domain */
    double default_value[4];    /* constant; of a choice, count or flag: [0] */
    double soft_min, soft_max;  /* the slider; equal: none */
    double hard_min, hard_max;  /* values outside are clamped; equal: none */
    const char* const* choices; /* of a choice: its names, lower_snake_case; else null */
    uint32_t choice_count;
    /* Of an image, the encoding of a bare path: "linear", "srgb", "normal_gl", "normal_dx",
     * "normal_rg", "normal_ag" or "derivative"; null is "linear". */
    const char* encoding;
} wr_port;

/* An old port name and what it is called since `version` (2 to the node's own). */
typedef struct wr_rename {
    uint32_t size;
    uint32_t version;
    const char* old_name;
    const char* new_name;
} wr_rename;

typedef struct wr_node {
    uint32_t size;
    uint32_t version;  /* from 1; grows when the meaning of a graph would change */
    const char* id;    /* lower_snake_case; the "type" in a graph; one among all plugins */
    const char* title; /* as the editor shows it */
    const char* doc;   /* one or two sentences */
    const char* family;
    const wr_port* const* ports; /* at most 256, with one output or more */
    uint32_t port_count;
    const wr_rename* const* renames; /* null without any */
    uint32_t rename_count;
    /* [build] Called once for each node of this type in a graph that is lowered. It gives every
     * output a value and returns; it reads no file and no clock, so that equal graphs give equal
     * text. `b` is the host's, until the return. */
    void (*build)(const wr_builder* b);
} wr_node;

typedef struct wr_plugin {
    uint32_t size;
    uint32_t abi;                /* WR_ABI */
    const char* id;              /* of the plugin, as diagnostics call it */
    const char* version;         /* of the plugin, for people */
    const wr_node* const* nodes; /* at most 10000, in the order of lists */
    uint32_t node_count;
    /* [load] A static struct of the extension "name/1", or null; may itself be null. */
    const void* (*get_extension)(const char* id);
} wr_plugin;

/* [load] The one exported symbol of a plugin. Static data, the same at every call; null and a
 * descriptor that breaks a rule above are refused with a diagnostic. */
WR_EXPORT const wr_plugin* wrinkle_plugin(void);
typedef const wr_plugin* (*wr_plugin_entry)(void);

#ifdef __cplusplus
}
#endif
#endif
