#pragma once
// Files by their names within an open folder, so that nobody can put a link in between, and files that appear
// under their names only when they are whole. A name has no separator; none of these functions follows a link
// of that name. Error numbers as in file.h.

#include <filesystem>
#include <span>
#include <string>

#include "system/file.h"

namespace glibra::system {

/// True for a name that means a file of that name in its folder and nothing else: no way to other folders, no
/// device, no part of a file.
bool isPlainName(const std::string& name);

/// What an open folder is for: in a sandbox some can be passed and not be listed.
enum class FolderUse { listed, passed };

/// Links on the way, and of the folder itself, are followed. An empty path is the current folder.
File openFolder(const std::filesystem::path& folder, FolderUse use = FolderUse::listed);
/// ELOOP: it is a link.
File openFolderIn(const File& folder, const std::string& name, FolderUse use);
/// Makes a folder. Returns 0 also if something has the name.
int makeFolderIn(const File& folder, const std::string& name);
/// Opens an ordinary file for reading. ELOOP: a link; ENOTSUP: a folder, a pipe or a device.
File openFileIn(const File& folder, const std::string& name);
/// Removes a file, a link, a pipe or a device. Returns 0 or an error number.
int removeIn(const File& folder, const std::string& name);
/// Removes what is no ordinary file, so that code which knows only paths can write there.
int clearNameIn(const File& folder, const std::string& name);

/// Writes a file that appears under its name when it is whole and on the disk, so that a loss of power leaves
/// the old file or the new one. It keeps the access of the old one (keepAccess). A link of that name is
/// replaced, and its target stays as it is.
int replaceIn(const File& folder, const std::string& name, std::span<const std::byte> bytes);

/// Renames a file within its folder, after its content is on the disk; then the folder is written to the
/// disk.
int renameDurably(const std::filesystem::path& from, const std::filesystem::path& to);

// Whole files by their paths.

/// True for a file that another one cannot stand for, because it would lose its owner, one of its names or
/// its access list.
bool mustStay(const std::filesystem::path& file);
/// Writes over an existing file. Room for it is reserved first, so that a full disk leaves the old content.
/// EACCES and EPERM: it may only be replaced.
int writeOver(const std::filesystem::path& file, std::span<const std::byte> bytes);
/// Gives a new file the group and the permissions of the file that it will replace, if there is one of the
/// same owner and without an access list. What the system does not permit is left out, never so that others
/// get more access than before. `keepsOwner`: the administrator, who may write the files of others, leaves
/// them their owner.
void keepAccess(const std::filesystem::path& replaced, const std::filesystem::path& by, bool keepsOwner);
/// Writes a file that has no name until it is complete, so that a process that is killed leaves nothing
/// behind, and puts it in the place of `file` with its access (keepAccess). ENOTSUP: the system or a sandbox
/// has no such files.
int replaceUnnamed(const std::filesystem::path& file, std::span<const std::byte> bytes, bool keepsOwner);
/// Removes a file, or a folder with all that is in it. Returns 0 or an error number; 0 also if there is none.
int removeTree(const std::filesystem::path& path);
/// Puts a file in the place of another one in the same file system. Returns 0 or an error number.
int renameOver(const std::filesystem::path& from, const std::filesystem::path& to);

// Names of files, where the system finds a file also by a name in another case.

/// A path whose parts are as their folders have them. They are those of the path, where the system tells
/// names in other cases apart, or has no such file.
std::filesystem::path asInFolders(const std::filesystem::path& path);
/// The same, absolute and without "." and "..": one path for all names of a file but links.
std::filesystem::path wholePath(const std::filesystem::path& path);
/// wholePath() with links followed, as far as the path exists; wholePath() if they cannot be. "" is the
/// current folder. No slash at its end.
std::filesystem::path realPath(const std::filesystem::path& path);
/// True if the real path is the folder or lies below it, with links followed. False if links cannot be
/// followed.
bool isBelow(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace glibra::system
