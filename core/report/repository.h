// Paths of files as CI systems and code hosts show them: relative to the root of the repository.
#pragma once

#include <filesystem>
#include <string>

namespace wrinkle::report {

// Returns the nearest of `folder`, which is absolute, and its parents that holds ".git"; `folder`
// if none does.
std::filesystem::path repository_root(const std::filesystem::path& folder);

// Returns the path of `file`, which is relative to the working folder or absolute, relative to
// `root`, with '/' between its parts; the absolute path if the file is outside. Links are not
// followed: the host shows the path as committed.
std::string path_in_repository(const std::string& file, const std::filesystem::path& root);

// Returns the path as a URI reference: bytes other than A-Z a-z 0-9 - . _ ~ / are percent-encoded
// (RFC 3986), and an absolute path begins with "file://".
std::string uri_of(const std::string& path);

}  // namespace wrinkle::report
