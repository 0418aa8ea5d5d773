// Faults of a plugin: X(name, action, beginning of the refusal message).
//
// One shared object, broken.so, performs the action of its file name: `loop.so`, a link to it,
// loops while it is loaded. The table lists each action with its message.
#pragma once

// clang-format off

// In a constructor, while the file is loaded
#define BROKEN_LOADING(X) \
    X(loop_while_loading, loop(), "it hung while it was loaded: it was ended after ") \
    X(loop_without_output, close_all(); loop(), "it hung while it was loaded: it was ended after ") \
    X(segv_while_loading, touch_nothing(), "it crashed while it was loaded: SIGSEGV (Segmentation fault)") \
    X(abort_while_loading, std::abort(), "it crashed while it was loaded: SIGABRT (Aborted)") \
    X(fpe_while_loading, raise(SIGFPE), "it crashed while it was loaded: SIGFPE (Floating point exception)") \
    X(bus_while_loading, raise(SIGBUS), "it crashed while it was loaded: SIGBUS (Bus error)") \
    X(killed_while_loading, raise(SIGKILL), "it crashed while it was loaded: SIGKILL (Killed)") \
    X(stopped_while_loading, raise(SIGSTOP), "it hung while it was loaded: it was ended after ") \
    X(exit_while_loading, std::exit(0), "it ended the program while it was loaded, with exit code 0") \
    X(exit_7_while_loading, _exit(7), "it ended the program while it was loaded, with exit code 7") \
    X(throw_while_loading, throw std::runtime_error("no licence"), "it threw an exception that nothing caught: no licence") \
    X(throw_5_while_loading, throw 5, "it threw an exception that nothing caught: something other than a std::exception") \
    X(lies_while_loading, say("fine\n{}"); _exit(0), "this is not a description of a plugin that this program knows") \
    X(babbles_while_loading, say("stage nowhere\n\xFF\xFE"); _exit(0), "it ended the program while its descriptors were read, with exit code 0")

// In wrinkle_plugin()
#define BROKEN_ENTRY(X) \
    X(loop_in_entry, loop(), "it hung in its wrinkle_plugin(): it was ended after ") \
    X(segv_in_entry, touch_nothing(), "it crashed in its wrinkle_plugin(): SIGSEGV (Segmentation fault)") \
    X(abort_in_entry, std::abort(), "it crashed in its wrinkle_plugin(): SIGABRT (Aborted)") \
    X(exit_in_entry, std::exit(3), "it ended the program in its wrinkle_plugin(), with exit code 3") \
    X(throw_in_entry, throw std::logic_error("not today"), "its wrinkle_plugin() threw an exception: not today") \
    X(throw_text_in_entry, throw "text", "its wrinkle_plugin() threw an exception: something other than a std::exception") \
    X(null_in_entry, result = nullptr, "its wrinkle_plugin() returned null") \
    X(wild_in_entry, result = nowhere<wr_plugin>(), "it crashed while its descriptors were read: SIGSEGV (Segmentation fault)")

// In the descriptors
#define BROKEN_PLUGIN(X) \
    X(abi_0, plugin.abi = 0, "it is made for plugin interface 0 (this program has interface 1)") \
    X(abi_2, plugin.abi = 2, "it is made for plugin interface 2 (this program has interface 1)") \
    X(plugin_size_0, plugin.size = 0, "its descriptor has the impossible size 0") \
    X(plugin_size_8, plugin.size = 8, "its descriptor has the impossible size 8") \
    X(plugin_id_null, plugin.id = nullptr, "the plugin's id is null") \
    X(plugin_id_wild, plugin.id = nowhere<char>(), "it crashed while its descriptors were read: SIGSEGV (Segmentation fault)") \
    X(plugin_id_bytes, plugin.id = "\xC3(", "the plugin's id is not valid UTF-8") \
    X(plugin_id_overlong, plugin.id = "\xC0\xAF", "the plugin's id is not valid UTF-8") \
    X(plugin_id_lines, plugin.id = "two\nlines", "the plugin's id holds a control character (one line of text)") \
    X(plugin_version_null, plugin.version = nullptr, "the plugin's version is null") \
    X(plugin_version_endless, plugin.version = endless, "the plugin's version has no end within 4096 bytes") \
    X(nodes_null, plugin.nodes = nullptr, "its list of nodes is null") \
    X(nodes_wild, plugin.nodes = nowhere<const wr_node*>(), "it crashed while its descriptors were read: SIGSEGV (Segmentation fault)") \
    X(nodes_many, plugin.node_count = 10001, "it claims 10001 nodes (at most 10000)") \
    X(nodes_most, plugin.node_count = ~0u, "it claims 4294967295 nodes (at most 10000)") \
    X(nodes_beyond, plugin.node_count = 10000, "node 'number 1': its descriptor is null") \
    X(node_null, nodes[0] = nullptr, "node 'number 0': its descriptor is null") \
    X(node_twice, nodes[1] = &node; plugin.node_count = 2, "node 'broken': the plugin has two nodes of this id")

#define BROKEN_NODE(X) \
    X(node_size_0, node.size = 0, "node 'number 0': its descriptor has the impossible size 0") \
    X(node_size_40, node.size = 40, "node 'number 0': its descriptor has the impossible size 40") \
    X(node_version_0, node.version = 0, "node 'broken': its version is 0 (versions count from 1)") \
    X(node_id_null, node.id = nullptr, "node 'number 0': the id is null") \
    X(node_id_empty, node.id = "", "node 'number 0': its id is not lower_snake_case") \
    X(node_id_upper, node.id = "Broken", "node 'Broken': its id is not lower_snake_case (letters a-z, digits and _, at most 64)") \
    X(node_id_digit, node.id = "2d", "node '2d': its id is not lower_snake_case") \
    X(node_id_dotted, node.id = "a.b", "node 'a.b': its id is not lower_snake_case") \
    X(node_id_bytes, node.id = "\xFF", "node 'number 0': the id is not valid UTF-8") \
    X(node_id_long, node.id = endless, "node 'number 0': the id has no end within 64 bytes") \
    X(node_id_reserved, node.id = "reroute", "node 'reroute': this id is reserved") \
    X(node_title_null, node.title = nullptr, "node 'broken': the title is null") \
    X(node_title_bytes, node.title = "\x80", "node 'broken': the title is not valid UTF-8") \
    X(node_doc_null, node.doc = nullptr, "node 'broken': the doc is null") \
    X(node_doc_endless, node.doc = endless, "node 'broken': the doc has no end within 4096 bytes") \
    X(node_family_null, node.family = nullptr, "node 'broken': the family is null") \
    X(node_family_surrogate, node.family = "\xED\xA0\x80", "node 'broken': the family is not valid UTF-8") \
    X(node_build_null, node.build = nullptr, "node 'broken': its build function is null") \
    X(ports_null, node.ports = nullptr, "node 'broken': its list of ports is null") \
    X(ports_many, node.port_count = 257, "node 'broken': it claims 257 ports (at most 256)") \
    X(ports_most, node.port_count = ~0u, "node 'broken': it claims 4294967295 ports (at most 256)") \
    X(ports_none, node.port_count = 0, "node 'broken': it has no output") \
    X(ports_without_output, node.port_count = 4, "node 'broken': it has no output") \
    X(renames_null, node.renames = nullptr, "node 'broken': its list of renamed ports is null or too long") \
    X(renames_many, node.rename_count = 257, "node 'broken': its list of renamed ports is null or too long") \
    X(rename_null, renames[0] = nullptr, "node 'broken': a renamed port is null or has an impossible size") \
    X(rename_size_8, rename_1.size = 8, "node 'broken': a renamed port is null or has an impossible size") \
    X(rename_version_1, rename_1.version = 1, "node 'broken': port 'size' was renamed in version 1 (expected 2 to 3)") \
    X(rename_version_9, rename_1.version = 9, "node 'broken': port 'size' was renamed in version 9 (expected 2 to 3)") \
    X(rename_bytes, rename_1.old_name = "\xFE", "node 'broken': the old name of a port is not valid UTF-8") \
    X(rename_to_itself, rename_1.new_name = "size", "node 'broken': port 'size' is renamed to 'size', which is renamed in the same version") \
    X(rename_in_a_circle, rename_2 = rename_1; std::swap(rename_2.old_name, rename_2.new_name); node.rename_count = 2, "node 'broken': port 'size' is renamed to 'value', which is renamed in the same version")

#define BROKEN_PORT(X) \
    X(port_null, ports[1] = nullptr, "node 'broken': port number 1: its descriptor is null") \
    X(port_wild, ports[1] = nowhere<wr_port>(), "it crashed while its descriptors were read: SIGSEGV (Segmentation fault)") \
    X(port_size_1, input.size = 1, "node 'broken': port number 0: its descriptor has the impossible size 1") \
    X(port_kind_0, input.kind = 0, "node 'broken': port 'value': its kind 0 does not exist") \
    X(port_kind_7, input.kind = 7, "node 'broken': port 'value': its kind 7 does not exist") \
    X(port_type_0, input.type = 0, "node 'broken': port 'value': its type 0 does not exist") \
    X(port_type_99, input.type = 99, "node 'broken': port 'value': its type 99 does not exist") \
    X(port_name_null, input.name = nullptr, "node 'broken': port number 0: the name is null") \
    X(port_name_spaced, input.name = "a b", "node 'broken': port 'a b': its name is not lower_snake_case") \
    X(port_name_bytes, input.name = "\xF8\x88", "node 'broken': port number 0: the name is not valid UTF-8") \
    X(port_name_twice, mode.name = "value", "node 'broken': port 'value': there is another port of this name") \
    X(port_doc_null, input.doc = nullptr, "node 'broken': port 'value': the doc is null") \
    X(port_unit_escape, input.unit = "\x1B[31m", "node 'broken': port 'value': the unit holds a control character") \
    X(default_kind_9, input.default_kind = 9, "node 'broken': port 'value': its kind of default 9 does not exist") \
    X(default_nan, input.default_value[0] = NAN, "node 'broken': port 'value': its default is not finite") \
    X(default_infinite, input.default_value[0] = INFINITY, "node 'broken': port 'value': its default is not finite") \
    X(default_outside, input.default_value[0] = 2, "node 'broken': port 'value': its default 2 is outside its range 0 to 1") \
    X(default_surface_99, input.default_kind = WR_DEFAULT_SURFACE; input.default_surface = 99, "node 'broken': port 'value': its surface property 99 does not exist") \
    X(default_surface_wide, input.default_kind = WR_DEFAULT_SURFACE, "node 'broken': port 'value': its default surface.position is not of type float") \
    X(default_of_gradient, input.type = WR_PORT_gradient, "node 'broken': port 'value': a default of type gradient cannot be") \
    X(range_backwards, input.hard_min = 3, "node 'broken': port 'value': a range ends before it begins") \
    X(range_nan, input.soft_max = NAN, "node 'broken': port 'value': a range ends before it begins") \
    X(choices_null, mode.choices = nullptr, "node 'broken': port 'mode': it has no choices") \
    X(choices_none, mode.choice_count = 0, "node 'broken': port 'mode': it has no choices") \
    X(choices_most, mode.choice_count = ~0u, "node 'broken': port 'mode': it claims 4294967295 choices (at most 256)") \
    X(choice_null, choices[0] = nullptr, "node 'broken': port 'mode': the name of a choice is null") \
    X(choice_upper, choices[0] = "Soft", "node 'broken': port 'mode': its choice \"Soft\" is not lower_snake_case") \
    X(choice_twice, choices[0] = "hard", "node 'broken': port 'mode': its choice 'hard' occurs twice") \
    X(choice_outside, mode.default_value[0] = 2, "node 'broken': port 'mode': its default 2 is outside 0 to 1") \
    X(choice_half, mode.default_value[0] = 0.5, "node 'broken': port 'mode': its default is not an integer") \
    X(image_encoding, image.encoding = "jpeg", "node 'broken': port 'image': its encoding \"jpeg\" does not exist") \
    X(field_of_image, field.type = WR_PORT_image, "node 'broken': port 'shape': a field of image cannot be") \
    X(field_domain, field.default_surface = 10, "node 'broken': port 'shape': its surface property 10 does not exist")

// clang-format on

#define BROKEN(X)     \
    BROKEN_LOADING(X) \
    BROKEN_ENTRY(X)   \
    BROKEN_PLUGIN(X)  \
    BROKEN_NODE(X)    \
    BROKEN_PORT(X)
