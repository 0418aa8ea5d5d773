#include "api/support.h"

#include <sys/wait.h>

#include <cstdlib>

namespace wrinkle::test {

Said run_wrinkle(const std::vector<std::string>& words) {
    const TemporaryFolder folder;
    const std::string out = folder.path() / "out", err = folder.path() / "err";
    std::string line = "WRINKLE_NO_DEFAULT_PLUGINS=1 " WRINKLE_BINARY_DIR "/bin/wrinkle";
    for (const std::string& word : words)
        line += " '" + word + "'";
    const int status = std::system((line + " >" + out + " 2>" + err).c_str());
    return {WEXITSTATUS(status), bytes_of(out), bytes_of(err)};
}

const api::Library& library() {
    static const api::Library made({{}, false});
    return made;
}

std::string tilt_graph(const std::string& slope) {
    return R"({ "wrinkle": 1,
  "inputs": { "slope": { "type": "float", "default": )" +
           slope + R"( } },
  "nodes": {
    "along": { "type": "gradient_from_volume", "in": { "volume": [1, 0, 0] } },
    "tilt": { "type": "gradient_scale",
      "in": { "gradient": { "from": "along.gradient" }, "amount": { "from": "input.slope" } } },
    "end": { "type": "resolve", "in": { "gradient": { "from": "tilt.gradient" } } }
  },
  "outputs": { "normal": { "from": "end.normal" } } })";
}

bool says(const api::Problems& problems, const std::string& words) {
    return to_text(problems).find(words) != std::string::npos;
}

}  // namespace wrinkle::test
