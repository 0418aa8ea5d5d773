// Where what a node makes of its picture differs from what the picture is, or the picture has a
// defect that the node feels.
//
//   green   the curl test says the other way than the encoding
//   type    a height read as normals and the like; blue of a map in two channels read as z
//   else    a defect's name (maps/lint.h); both seams are one remark, where the texture repeats
//
// Said of nodes that make bumps of pictures and of no others: what a colour is, is nobody's guess.
#pragma once

#include "editor/images/images.h"

namespace wrinkle::editor {

std::vector<Remark> find_remarks(const State& state);

// The document after the remedy; itself where there is none any more.
Document remedied(const State& state, const Remark& remark);
void apply_remedy(State& state, const Remark& remark);  // one step
void dismiss_remark(State& state, const Remark& remark);

// What a dismissal is kept by: a newer version of the file is remarked upon anew.
std::string dismissal_mark(const std::filesystem::path& file, const Stamp& version,
                           std::string_view about);

}  // namespace wrinkle::editor
