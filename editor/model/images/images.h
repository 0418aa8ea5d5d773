// Classification and defects of the open graph's images, as by `wrinkle lint` (maps/lint.h):
// computed in the background, one image at a time, once for each version of a file.
//
// Images of the top graph are examined when it is opened and when their files change, dropped ones
// before they get a node. If a node's use of an image does not match the image, there is a remark
// (ImageWarning), shown in the problems and on the node until it is resolved or dismissed
// permanently: the settings store dismissals by file version.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "editor/model/document/watch.h"
#include "editor/model/worker.h"
#include "graph/document.h"
#include "image/load.h"
#include "maps/lint.h"

namespace wrinkle::editor {

struct Session;
struct UsedFile;

struct Examined {
    Stamp stamp;          // file version that was examined
    std::string problem;  // one sentence: why it could not be read; "" if the rest is valid
    ImageInfo info;
    maps::Verdict verdict;  // under the assumption that the image repeats
};
// Callable on any thread. If `stopped` returns true, the result must be discarded.
Examined examine_file(const std::filesystem::path& file, const std::function<bool()>& stopped = {});

struct ImageAnswer {
    std::filesystem::path file;
    Examined examined;
};
using ImageExaminer = Worker<std::filesystem::path, ImageAnswer>;

// A fix that is certain to help, as an edit of the node's input or type.
struct Remedy {
    enum class Kind : uint8_t { none, encoding, wrap, type };
    Kind kind = Kind::none;
    std::string label;  // "Read as dx"
    std::string word;   // new word of the input, or id of the new type
};
struct ImageWarning {
    Diagnostic problem{.rule = RuleId::image_meaning};  // a warning at the node's input
    std::string port, file;
    std::string about;  // key of the dismissal: "green", "type", a finding's name
    Remedy remedy;
};

struct Images {
    ImageExaminer* examiner = nullptr;                   // nullptr: examined on the calling thread
    std::map<std::string, std::filesystem::path> paths;  // by the names in the graph
    std::map<std::filesystem::path, Examined> known;
    std::vector<std::filesystem::path> wanted;  // pending; the first one is examined now
    uint64_t changes = 0;  // increases when a result or `paths` changes: remarks are updated

    std::vector<ImageWarning> remarks;
    Document remarks_of;
    uint64_t remarks_at = 0;

    bool busy() const { return !wanted.empty(); }
};

// Examines this version of the file unless it is done; `first` puts it at the front of the queue.
void want_image(Session& session, const std::filesystem::path& file, const Stamp& stamp,
                bool first);
// Returns nullptr if the file is not examined yet or a newer version is pending.
const Examined* examined(const Session& session, const std::filesystem::path& file);
// Same for a node's image, by its name in the graph.
const Examined* examined_at(const Session& session, const Node& node, std::string_view port);

// Sets the files that the graph currently uses; `dropped` are retained too.
void follow_images(Session& session, const std::vector<UsedFile>& files,
                   const std::vector<std::filesystem::path>& dropped);
// Called once a frame: takes results and updates the remarks.
void poll_images(Session& session);

}  // namespace wrinkle::editor
