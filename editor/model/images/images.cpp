#include "editor/model/images/images.h"

#include <algorithm>

#include "base/text.h"
#include "editor/model/images/remarks.h"
#include "editor/model/session.h"
#include "lower/literal.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

void keep_answer(Session& session, ImageAnswer answer) {
    Images& images = session.images;
    std::erase(images.wanted, answer.file);
    images.known[answer.file] = std::move(answer.examined);
    ++images.changes;
}

Examined read_and_examine(const fs::path& file, const std::function<bool()>& stopped) {
    Examined result;
    result.stamp = stamp_of(file);
    Diagnostics problems;
    auto found = maps::examine(file, Wrap::repeat, problems, stopped);
    if (!found) {
        result.problem = file.filename().string() + " cannot be used";
        for (const Diagnostic& each : problems.list())
            if (each.severity == Severity::error) result.problem = each.message;
        return result;
    }
    result.info = found->info;
    result.verdict = std::move(found->verdict);
    return result;
}

}  // namespace

Examined examine_file(const fs::path& file, const std::function<bool()>& stopped) {
    try {
        return read_and_examine(file, stopped);
    } catch (...) {  // most likely out of memory
        Examined result;
        result.stamp = stamp_of(file);
        result.problem = file.filename().string() + " cannot be looked at: " + exception_text();
        return result;
    }
}

void want_image(Session& session, const fs::path& file, const Stamp& stamp, bool first) {
    Images& images = session.images;
    const auto known = images.known.find(file);
    if (known != images.known.end() && known->second.stamp == stamp) return;
    if (!images.examiner) return keep_answer(session, {file, examine_file(file)});
    std::vector<fs::path>& wanted = images.wanted;
    const auto at = std::ranges::find(wanted, file);
    if (at == wanted.begin() && at != wanted.end()) return;
    if (at != wanted.end() && !first) return;
    if (at != wanted.end()) wanted.erase(at);
    const bool running = !images.examiner->idle() && !wanted.empty();
    wanted.insert(first ? wanted.begin() + (running ? 1 : 0) : wanted.end(), file);
}

const Examined* examined(const Session& session, const fs::path& file) {
    const Images& images = session.images;
    const auto known = images.known.find(file);
    const bool waits = std::ranges::find(images.wanted, file) != images.wanted.end();
    return known == images.known.end() || waits ? nullptr : &known->second;
}

const Examined* examined_at(const Session& session, const Node& node, std::string_view port) {
    const Input* input = node.find(port);
    if (!input || input->kind != Input::Kind::literal) return nullptr;
    const std::string file(literal_image(input->value).file);
    const auto path = session.images.paths.find(file);
    return path == session.images.paths.end() ? nullptr : examined(session, path->second);
}

void follow_images(Session& session, const std::vector<UsedFile>& files,
                   const std::vector<fs::path>& dropped) {
    Images& images = session.images;
    std::map<std::string, fs::path> paths;
    for (const UsedFile& file : files) {
        if (file.name.empty()) continue;
        paths[file.name] = file.path;
        if (file.stamp.there && file.stamp.size > 0)
            want_image(session, file.path, file.stamp, false);
    }
    if (paths == images.paths) return;
    images.paths = std::move(paths);
    ++images.changes;
    const auto is_read = [&](const fs::path& file) {
        return std::ranges::any_of(images.paths,
                                   [&](const auto& each) { return each.second == file; }) ||
               std::ranges::find(dropped, file) != dropped.end();
    };
    std::erase_if(images.known, [&](const auto& each) { return !is_read(each.first); });
    std::erase_if(images.wanted, [&](const fs::path& file) {
        return &file != &images.wanted.front() && !is_read(file);
    });
}

void poll_images(Session& session) {
    Images& images = session.images;
    if (images.examiner) {
        if (auto answer = images.examiner->take()) keep_answer(session, std::move(*answer));
        if (!images.wanted.empty() && images.examiner->idle())
            images.examiner->post(images.wanted.front());
    }
    if (!session.is_synced) return;
    if (images.remarks_at == images.changes && same_document(images.remarks_of, session.document()))
        return;
    images.remarks_at = images.changes;
    images.remarks_of = session.document();
    images.remarks = find_remarks(session);
}

}  // namespace wrinkle::editor
