// What the pictures of the open graph are and what is wrong with them, as `wrinkle lint` says it
// (maps/lint.h): found beside the interface, one picture at a time, each version of a file once.
//
// Pictures of the top graph are looked at when it is opened and when their files change, dropped
// ones before they get a node. What a node makes of its picture is set against what the picture is:
// a remark, shown among the problems and on the node until it is mended or dismissed, for
// good: the settings keep that, by the version of the file.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "editor/document/watch.h"
#include "editor/worker.h"
#include "graph/document.h"
#include "image/load.h"
#include "maps/lint.h"

namespace wrinkle::editor {

struct State;
struct UsedFile;

struct Examined {
    Stamp stamp;          // of the version that was looked at
    std::string problem;  // one sentence: why it could not be read; else the rest holds
    ImageInfo info;
    maps::Verdict verdict;  // as of a picture that is to repeat
};
// On any thread. Where `stopped` comes to say true the answer is nobody's.
Examined examine_file(const std::filesystem::path& file, const std::function<bool()>& stopped = {});

struct ImageAnswer {
    std::filesystem::path file;
    Examined examined;
};
using ImageExaminer = Worker<std::filesystem::path, ImageAnswer>;

// The one thing that is certain to help, as an edit of the node's input or type.
struct Remedy {
    enum class Kind : uint8_t { none, encoding, wrap, type };
    Kind kind = Kind::none;
    std::string label;  // "Read as dx"
    std::string word;   // of the input, or the new type's id
};
struct Remark {
    Diagnostic problem;  // a warning at the node's input
    std::string port, file;
    std::string about;  // what is dismissed with it: "green", "type", a finding's name
    Remedy remedy;
};

struct Images {
    ImageExaminer* examiner = nullptr;                   // nullptr: looked at at once
    std::map<std::string, std::filesystem::path> paths;  // by the names that the graph writes
    std::map<std::filesystem::path, Examined> known;
    std::vector<std::filesystem::path> wanted;  // still to be looked at; the first one is, now
    uint64_t changes = 0;                       // of all that remarks follow from, but the document

    std::vector<Remark> remarks;
    Document remarks_of;
    uint64_t remarks_at = 0;

    bool busy() const { return !wanted.empty(); }
};

// Looks at this version of the file, unless it was; what somebody waits for goes `first`.
void want_image(State& state, const std::filesystem::path& file, const Stamp& stamp, bool first);
// nullptr: not looked at yet, or a newer version is to be.
const Examined* examined(const State& state, const std::filesystem::path& file);
// That of a node's picture, by its name in the graph.
const Examined* examined_at(const State& state, const Node& node, std::string_view port);

// The files that the graph is known to be made of now.
void follow_images(State& state, const std::vector<UsedFile>& files);
// Once a frame: takes what was found, and keeps the remarks true.
void tend_images(State& state);

}  // namespace wrinkle::editor
