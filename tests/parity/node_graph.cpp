#include "parity/node_graph.h"

#include <gtest/gtest.h>

#include "glslang/validate.h"
#include "nodes/all.h"
#include "registry/plugin_loader.h"

namespace wrinkle::test {

const Registry& all_nodes() {
    static const Registry registry = [] {
        Registry made;
        Diagnostics diagnostics;
        EXPECT_TRUE(made.add_plugin(built_in_nodes(), Registry::built_in, diagnostics))
            << to_text(diagnostics);
        const std::vector<std::string> folder{PLUGIN_FOLDER};
        if (std::filesystem::is_directory(folder.front())) {
            load_plugins(made, folder, diagnostics);
            EXPECT_TRUE(diagnostics.list().empty()) << to_text(diagnostics);
        }
        return made;
    }();
    return registry;
}

std::string image_folder() {
    static const auto folder = [] {
        std::string why;
        auto made = certify::make_image_folder(why);
        EXPECT_TRUE(made) << why;
        return made;
    }();
    return folder ? folder->string() : "";
}

certify::CertifyContext bench(bool gpu) {
    return {all_nodes(), image_folder(), gpu, [](const Shader& shader) {
                const bool judged = has_validator(*find_target(shader.reflection.target));
                return judged ? compile_errors(shader) : std::string();
            }};
}

Subject compile_harness(const NodeType& type, Inputs inputs, unsigned seed) {
    Subject subject = certify::compile_harness(type, inputs, seed, bench());
    EXPECT_TRUE(subject.compiled.ok)
        << "no graph around '" << type.id << "' is legal: " << subject.problem << "\n"
        << subject.text;
    return subject;
}

}  // namespace wrinkle::test
