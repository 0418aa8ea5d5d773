/* Wrinkle as a library for C, and for languages that call C: loads, checks, compiles, exports and
 * evaluates graphs. wrinkle.hpp is the same library for C++; docs/c-library.md is a tour.
 *
 * Objects    Functions with _new, _load, _with, _compile, _evaluate, _check in their names return
 *            an object that the caller frees with its _free function, and null only without memory.
 *            A null object is an empty one: what it makes has a problem that names it, and what it
 *            holds is 0, false or null. An object keeps those alive that it was made of.
 * Strings    UTF-8, zero-terminated. A returned string or array lives as long as its object.
 * Errors     A failure is a list of problems with the user's file, line and node.
 * Threads    Library and graph may be used by several threads at once. An evaluator may not: each
 *            thread takes a copy. Points and results must not change while another thread reads.
 * Versions   The soname changes with every version outside 0.2.x. Requires C99.
 */
#ifndef WRINKLE_WRINKLE_H
#define WRINKLE_WRINKLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define WRINKLE_C_API __attribute__((visibility("default")))

#ifdef __cplusplus
extern "C" {
#endif

typedef struct wrinkle_library wrinkle_library;     /* node types, with those of plugins */
typedef struct wrinkle_graph wrinkle_graph;         /* immutable */
typedef struct wrinkle_problems wrinkle_problems;
typedef struct wrinkle_shader wrinkle_shader;       /* generated source */
typedef struct wrinkle_files wrinkle_files;         /* names of files */
typedef struct wrinkle_evaluator wrinkle_evaluator; /* a graph compiled for evaluation */
typedef struct wrinkle_points wrinkle_points;       /* surface points */
typedef struct wrinkle_results wrinkle_results;     /* values of the outputs at points */

WRINKLE_C_API const char* wrinkle_version(void); /* "0.2.0" */

/* Problems. */
typedef struct wrinkle_problem {
    bool is_error;         /* else a warning */
    const char* file;      /* "": the caller or the environment is at fault */
    uint32_t line, column; /* from 1; 0: the file in general */
    const char* pointer;   /* JSON pointer of the token */
    const char* node;
    const char* message;
    const char* expected; /* hint: the valid form; may be "" */
    const char* text;     /* all of it in one line, as `wrinkle check` prints it */
} wrinkle_problem;

WRINKLE_C_API size_t wrinkle_problems_count(const wrinkle_problems*);
WRINKLE_C_API const wrinkle_problem* wrinkle_problems_at(const wrinkle_problems*, size_t index);
WRINKLE_C_API bool wrinkle_problems_have_errors(const wrinkle_problems*);
WRINKLE_C_API const char* wrinkle_problems_text(const wrinkle_problems*); /* one line for each */
WRINKLE_C_API void wrinkle_problems_free(wrinkle_problems*);

/* Library. `plugins` are `count` plugins or folders of them; `default_plugins` also searches the
 * folders of docs/plugins.md. */
WRINKLE_C_API wrinkle_library* wrinkle_library_new(const char* const* plugins, size_t count,
                                                   bool default_plugins);
WRINKLE_C_API const wrinkle_problems* wrinkle_library_problems(const wrinkle_library*);
WRINKLE_C_API void wrinkle_library_free(wrinkle_library*);

/* Graphs. The files that a graph names must be below `root`; null is the folder of the graph.
 * load_text() takes the text of a graph whose file would be FOLDER/NAME. */
WRINKLE_C_API wrinkle_graph* wrinkle_graph_load(const wrinkle_library*, const char* file,
                                                const char* root);
WRINKLE_C_API wrinkle_graph* wrinkle_graph_load_text(const wrinkle_library*, const char* text,
                                                     const char* folder, const char* name,
                                                     const char* root);
/* Return the graph with other values: "NODE.PORT=VALUE" or "input.NAME=VALUE", as for --set; and
 * with those of a preset, by its name or a file that ends in ".json". */
WRINKLE_C_API wrinkle_graph* wrinkle_graph_with(const wrinkle_graph*, const char* const* values,
                                                size_t count);
WRINKLE_C_API wrinkle_graph* wrinkle_graph_with_preset(const wrinkle_graph*, const char* name);
WRINKLE_C_API wrinkle_problems* wrinkle_graph_check(const wrinkle_graph*);
WRINKLE_C_API size_t wrinkle_graph_preset_count(const wrinkle_graph*);
WRINKLE_C_API const char* wrinkle_graph_preset(const wrinkle_graph*, size_t index);
WRINKLE_C_API void wrinkle_graph_free(wrinkle_graph*);

/* Files that the graph reads, graphs first; for build systems and file watchers. */
WRINKLE_C_API wrinkle_files* wrinkle_graph_inputs(const wrinkle_graph*);
WRINKLE_C_API size_t wrinkle_files_count(const wrinkle_files*);
WRINKLE_C_API const char* wrinkle_files_at(const wrinkle_files*, size_t index);
WRINKLE_C_API const wrinkle_problems* wrinkle_files_problems(const wrinkle_files*);
WRINKLE_C_API void wrinkle_files_free(wrinkle_files*);

/* Compilation. An option is "NAME=VALUE" with the long options of `wrinkle compile`: target, form,
 * params, differentials, srgb, normal-space, uv-origin, descriptor-set, first-binding, name; and
 * no-tangents and strict, which are true or false. Texts are "" after an error. SPIR-V is binary;
 * `size`, which may be null, receives its length. */
WRINKLE_C_API wrinkle_shader* wrinkle_graph_compile(const wrinkle_graph*,
                                                    const char* const* options, size_t count);
WRINKLE_C_API const wrinkle_problems* wrinkle_shader_problems(const wrinkle_shader*);
WRINKLE_C_API const char* wrinkle_shader_source(const wrinkle_shader*, size_t* size);
WRINKLE_C_API const char* wrinkle_shader_vertex(const wrinkle_shader*, size_t* size);
WRINKLE_C_API const char* wrinkle_shader_fragment(const wrinkle_shader*, size_t* size);
WRINKLE_C_API const char* wrinkle_shader_reflection(const wrinkle_shader*, size_t* size);
WRINKLE_C_API void wrinkle_shader_free(wrinkle_shader*);

/* Export, as `wrinkle export`: writes the files of a host ("three", "gltf", ...) to `folder` and
 * returns their names. `mesh` is a sphere, plane, ... or a file; null is "sphere". `size` is the
 * side of baked maps in texels; 0 is 1024. `name` is an identifier; null is the graph's file. */
WRINKLE_C_API wrinkle_files* wrinkle_graph_export(const wrinkle_graph*, const char* host,
                                                  const char* folder, const char* mesh,
                                                  uint32_t size, const char* name);

/* Evaluation. Numeric inputs of the graph have an index, and change without another compilation. */
WRINKLE_C_API wrinkle_evaluator* wrinkle_evaluator_new(const wrinkle_graph*);
WRINKLE_C_API wrinkle_evaluator* wrinkle_evaluator_copy(const wrinkle_evaluator*);
WRINKLE_C_API const wrinkle_problems* wrinkle_evaluator_problems(const wrinkle_evaluator*);
WRINKLE_C_API size_t wrinkle_evaluator_input_count(const wrinkle_evaluator*);
WRINKLE_C_API const char* wrinkle_evaluator_input_name(const wrinkle_evaluator*, size_t input);
WRINKLE_C_API size_t wrinkle_evaluator_input_components(const wrinkle_evaluator*, size_t input);
WRINKLE_C_API const double* wrinkle_evaluator_input_value(const wrinkle_evaluator*, size_t input);
/* Returns the index of an input, which may be called by a former name; -1 if there is none. */
WRINKLE_C_API int wrinkle_evaluator_find(const wrinkle_evaluator*, const char* input);
/* Replaces the value of an input, clamped to its limits. Returns false, and keeps the value, if the
 * input or the number of components is another, or if a number is not finite. */
WRINKLE_C_API bool wrinkle_evaluator_set(wrinkle_evaluator*, int input, const double* value,
                                         size_t components);
WRINKLE_C_API void wrinkle_evaluator_free(wrinkle_evaluator*);

/* Points. `name` is position, normal, tangent, uv0 ... uv3, color0, view, facing, or the difference
 * to the next pixel, dx.NAME or dy.NAME; `values` are the numbers of the first point, of the second
 * and so on. Without memory, set() returns false. */
WRINKLE_C_API wrinkle_points* wrinkle_points_new(size_t count);
WRINKLE_C_API bool wrinkle_points_set(wrinkle_points*, const char* name, const double* values,
                                      size_t numbers);
WRINKLE_C_API void wrinkle_points_free(wrinkle_points*);

/* Results: the outputs in the graph's order; none after an error. */
WRINKLE_C_API wrinkle_results* wrinkle_evaluator_evaluate(const wrinkle_evaluator*,
                                                          const wrinkle_points*,
                                                          bool double_precision);
WRINKLE_C_API const wrinkle_problems* wrinkle_results_problems(const wrinkle_results*);
WRINKLE_C_API size_t wrinkle_results_count(const wrinkle_results*);
WRINKLE_C_API const char* wrinkle_results_name(const wrinkle_results*, size_t output);
WRINKLE_C_API size_t wrinkle_results_components(const wrinkle_results*, size_t output);
WRINKLE_C_API const double* wrinkle_results_values(const wrinkle_results*, size_t output);
WRINKLE_C_API void wrinkle_results_free(wrinkle_results*);

#ifdef __cplusplus
}
#endif

#endif
