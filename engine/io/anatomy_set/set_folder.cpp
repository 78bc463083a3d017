#include "engine/io/anatomy_set/set_folder.h"

#include "engine/io/files/folder_path.h"
#include "engine/io/files/open_file.h"
#include "engine/io/files/whole_file.h"
#include "engine/io/mesh/surface_format.h"
#include "engine/io/mesh/surface_text.h"

#include <QCryptographicHash>
#include <QStringList>

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>

namespace carina
{
namespace
{

namespace fs = std::filesystem;

constexpr const char* kManifest = "MANIFEST.tsv";
constexpr const char* kSource = "SOURCE.txt";
constexpr std::size_t kLongestName = 4096; ///< that Linux opens

bool isCompanion(const fs::path& file)
{
    if (file.filename() == kManifest || file.filename() == kSource)
        return true;
    const QString ending = QString::fromStdString(file.extension().string()).toLower();
    static const QStringList kEndings = QStringLiteral(".bin .mtl .png .jpg .jpeg").split(u' ');
    return kEndings.contains(ending);
}

void addLength(QCryptographicHash& hash, std::uint64_t length)
{
    hash.addData(QByteArray::number(qulonglong(length)) + ' ');
}

/// Hashes a text so that no other sequence of texts gives the same bytes.
void addText(QCryptographicHash& hash, std::string_view text)
{
    addLength(hash, text.size());
    hash.addData(QByteArrayView{text.data(), static_cast<qsizetype>(text.size())});
}

/// Hashes the content of a file as addText does, piece by piece. Of a file that is too large the
/// importer uses nothing, and here only its size counts.
void addFile(QCryptographicHash& hash, const fs::path& root, const std::string& file)
{
    const auto opened = pathWithin(root, file).and_then([](const fs::path& found) {
        return OpenFile::of(found, limitOfSetFile(found));
    });
    if (!opened) {
        std::error_code error;
        const auto size = fs::file_size(root / file, error);
        const bool tooLarge = opened.error().code == Errc::FileTooLarge;
        return addText(hash, tooLarge ? "bytes: " + std::to_string(size) : std::string{});
    }
    std::vector<std::byte> piece(std::min<std::uint64_t>(kMebibyte, opened->size()));
    addLength(hash, opened->size());
    for (std::uint64_t left = opened->size(); left > 0;) {
        const auto most = std::min<std::uint64_t>(left, piece.size());
        const std::ptrdiff_t count = opened->read(std::span{piece}.first(most));
        if (count <= 0)
            return; // it became shorter; the importer says so
        hash.addData(QByteArrayView{piece.data(), count});
        left -= std::uint64_t(count);
    }
}

std::string inHex(const QCryptographicHash& hash) { return hash.result().toHex().toStdString(); }

std::vector<std::string> allFiles(const SetFolder& folder)
{
    std::vector<std::string> files = folder.surfaces;
    files.insert(files.end(), folder.companions.begin(), folder.companions.end());
    return files;
}

Error othersMissing()
{
    return {Errc::FileNotFound,
            "more files are missing than the " + std::to_string(kMostMissingFiles) + " named"};
}

template <class Visit>
void forEachCompanion(const SetFolder& folder, const char* name, const Visit& visit)
{
    for (const std::string& file : folder.companions) {
        if (fs::path{file}.filename() != name)
            continue;
        const auto text = pathWithin(folder.root, file).and_then([](const fs::path& found) {
            return readWholeFile(found, kDescriptionLimit);
        });
        if (text)
            visit(file, *text);
    }
}

/// The cell of a line of tab-separated values; empty beyond the last.
std::string_view cell(std::string_view line, std::size_t column)
{
    for (; column > 0; --column)
        line.remove_prefix(std::min(line.find('\t'), line.size() - 1) + 1);
    line = line.substr(0, line.find('\t'));
    return line.substr(0, line.find('\r'));
}

/// The column of this name in the header; nothing where it is none of the first.
std::optional<std::size_t> columnOf(std::string_view header, std::string_view name)
{
    for (std::size_t column = 0; column < kMostManifestColumns; ++column) {
        if (cell(header, 0) == name)
            return column;
        const std::size_t end = header.find('\t');
        if (end == std::string_view::npos)
            break;
        header.remove_prefix(end + 1);
    }
    return std::nullopt;
}

} // namespace

Result<SetFolder> listSetFolder(const fs::path& root)
{
    std::error_code error;
    if (!fs::is_directory(root, error))
        return fail(Errc::FileNotFound,
                    root.string()
                        + (fs::exists(root, error) ? ": it is not a folder" : ": no such folder"));
    SetFolder folder{root, {}, {}};
    const auto options = fs::directory_options::skip_permission_denied;
    for (auto it = fs::recursive_directory_iterator{root, options, error};
         it != fs::recursive_directory_iterator{}; it.increment(error)) {
        if (error || it->is_directory(error))
            continue;
        const std::string file = it->path().lexically_relative(root).generic_string();
        if (surfaceFormat(it->path()))
            folder.surfaces.push_back(file);
        else if (isCompanion(it->path()))
            folder.companions.push_back(file);
    }
    std::sort(folder.surfaces.begin(), folder.surfaces.end());
    std::sort(folder.companions.begin(), folder.companions.end());
    if (folder.surfaces.empty())
        return fail(Errc::NothingRecognised, root.string() + ": no surfaces in it");
    return folder;
}

std::string contentHashOf(const SetFolder& folder)
{
    QCryptographicHash hash{QCryptographicHash::Sha256};
    for (const std::string& file : allFiles(folder)) {
        addText(hash, file);
        addFile(hash, folder.root, file);
    }
    return inHex(hash);
}

std::string listingHashOf(const SetFolder& folder)
{
    QCryptographicHash hash{QCryptographicHash::Sha256};
    std::error_code error;
    addText(hash, fs::absolute(folder.root, error).string());
    for (const std::string& file : allFiles(folder)) {
        addText(hash, file);
        addText(hash, std::to_string(fs::file_size(folder.root / file, error)));
        const auto written = fs::last_write_time(folder.root / file, error);
        addText(hash, std::to_string(written.time_since_epoch().count()));
    }
    return inHex(hash);
}

std::vector<FileFault> missingFiles(const SetFolder& folder)
{
    std::set<fs::path> present;
    for (const std::string& file : folder.surfaces)
        present.insert(fs::path{file}.filename());
    std::vector<FileFault> missing;
    const auto addMissing = [&](const std::string& name, const std::string& manifest) {
        if (missing.size() == kMostMissingFiles)
            missing.push_back({manifest, othersMissing()});
        if (missing.size() < kMostMissingFiles)
            missing.push_back(
                {name, {Errc::FileNotFound, name + ": missing, though named in " + manifest}});
    };
    forEachCompanion(folder, kManifest, [&](const std::string& manifest, std::string_view text) {
        const auto column = columnOf(takeLine(text), "file");
        while (column && !text.empty() && missing.size() <= kMostMissingFiles) {
            const std::string name{cell(takeLine(text), *column).substr(0, kLongestName)};
            if (!name.empty() && !present.contains(fs::path{name}.filename()))
                addMissing(name, manifest);
        }
    });
    return missing;
}

std::vector<std::string> attributionsBeside(const SetFolder& folder)
{
    std::vector<std::string> lines;
    forEachCompanion(folder, kSource, [&](const std::string&, std::string_view text) {
        while (!text.empty())
            if (const std::string_view line = takeLine(text);
                line.starts_with("LICENCE") || line.starts_with("LICENSE"))
                lines.emplace_back(line);
    });
    return lines;
}

} // namespace carina
