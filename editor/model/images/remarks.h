// Mismatches between a node's use of an image and the image, and defects that affect the node.
//
//   green   the curl test contradicts the encoding
//   type    a height read as normals and the like; blue of a map in two channels read as z
//   else    a defect's name (maps/lint.h); both seams are one remark, if the texture repeats
//
// Only nodes that make bumps of images get remarks: the meaning of colors cannot be determined.
#pragma once

#include "editor/model/images/images.h"

namespace wrinkle::editor {

std::vector<ImageWarning> find_remarks(const Session& session);

// Returns the document after the remedy; the current one if it no longer applies.
Document remedied(const Session& session, const ImageWarning& remark);
void apply_remedy(Session& session, const ImageWarning& remark);  // one undo step
void dismiss_remark(Session& session, const ImageWarning& remark);

// Key that stores a dismissal: a newer version of the file gets a remark again.
std::string dismissal_mark(const std::filesystem::path& file, const Stamp& version,
                           std::string_view about);

}  // namespace wrinkle::editor
