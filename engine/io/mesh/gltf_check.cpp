#include "engine/io/files/file_limit.h"
#include "engine/io/files/folder_path.h"
#include "engine/io/mesh/surface_check.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <vector>

namespace carina
{
namespace
{

constexpr double kLargestCount = 1e9; ///< beyond any surface; products of two stay exact

QString key(const char* name) { return QString::fromLatin1(name); }

Result<void> badGltf(const std::string& fault) { return fail(Errc::FileMalformed, fault); }

/// A count or an offset: a whole number from 0 on, `absent` where it is not given.
std::optional<double> whole(const QJsonObject& object, const char* name, double absent = 0.0)
{
    const QJsonValue value = object.value(key(name));
    if (value.isUndefined())
        return absent;
    const double number = value.toDouble(-1.0);
    if (number < 0.0 || number > kLargestCount || number != std::floor(number))
        return std::nullopt;
    return number;
}

double bytesOfComponent(int type)
{
    static const std::map<int, double> kBytes{{5120, 1.0}, {5121, 1.0}, {5122, 2.0},
                                              {5123, 2.0}, {5125, 4.0}, {5126, 4.0}};
    const auto found = kBytes.find(type);
    return found == kBytes.end() ? 0.0 : found->second;
}

double componentsOf(const QString& type)
{
    static const std::map<QString, double> kComponents{
        {key("SCALAR"), 1.0}, {key("VEC2"), 2.0}, {key("VEC3"), 3.0}, {key("VEC4"), 4.0},
        {key("MAT2"), 4.0},   {key("MAT3"), 9.0}, {key("MAT4"), 16.0}};
    const auto found = kComponents.find(type);
    return found == kComponents.end() ? 0.0 : found->second;
}

/// Whether a buffer in a file of its own lies within the folder and is as long as declared.
Result<void> checkBuffer(const std::string& uri, const std::optional<std::filesystem::path>& folder,
                         double declared)
{
    const std::string name =
        QByteArray::fromPercentEncoding(QByteArray::fromStdString(uri)).toStdString();
    if (!folder || name.starts_with('/') || name.find("..") != std::string::npos)
        return badGltf("a buffer outside its folder: " + uri);
    const auto file = pathWithin(*folder, name);
    if (!file && file.error().code == Errc::FileNotFound)
        return fail(Errc::FileNotFound, "its buffer " + uri + " is missing");
    if (!file)
        return tl::unexpected(file.error());
    const auto size = readableSize(*file, kSurfaceLimit);
    if (!size)
        return tl::unexpected(size.error());
    if (static_cast<double>(*size) < declared)
        return badGltf("truncated: its buffer " + uri + " is too short");
    return {};
}

/// The length of each buffer, having made sure that its bytes are there.
/// @param binaryChunk length of the binary chunk of a GLB.
Result<std::vector<double>> bufferLengths(const QJsonObject& root,
                                          const std::optional<std::filesystem::path>& folder,
                                          std::optional<double> binaryChunk)
{
    std::vector<double> lengths;
    for (const QJsonValue& value : root.value(key("buffers")).toArray()) {
        const QJsonObject buffer = value.toObject();
        const auto declared = whole(buffer, "byteLength");
        if (!declared)
            return fail(Errc::FileMalformed, "a buffer without a length");
        lengths.push_back(*declared);
        const std::string uri = buffer.value(key("uri")).toString().toStdString();
        if (uri.starts_with("data:"))
            continue; // the length of what it holds is the reader's to check
        if (uri.empty()) {
            if (!binaryChunk || *binaryChunk < *declared)
                return fail(Errc::FileMalformed, "truncated: a buffer is not there whole");
            continue;
        }
        if (const auto there = checkBuffer(uri, folder, *declared); !there)
            return tl::unexpected(there.error());
    }
    return lengths;
}

Result<std::vector<double>> viewLengths(const QJsonObject& root,
                                        const std::vector<double>& bufferLengths)
{
    std::vector<double> lengths;
    for (const QJsonValue& value : root.value(key("bufferViews")).toArray()) {
        const QJsonObject view = value.toObject();
        const auto buffer = whole(view, "buffer");
        const auto offset = whole(view, "byteOffset");
        const auto length = whole(view, "byteLength");
        if (!buffer || !offset || !length || *buffer >= double(bufferLengths.size())
            || *offset + *length > bufferLengths[static_cast<std::size_t>(*buffer)])
            return fail(Errc::FileMalformed, "a view outside its buffer");
        lengths.push_back(*length);
    }
    return lengths;
}

Result<void> checkAccessors(const QJsonObject& root, const std::vector<double>& viewLengths)
{
    const QJsonArray views = root.value(key("bufferViews")).toArray();
    for (const QJsonValue& value : root.value(key("accessors")).toArray()) {
        const QJsonObject accessor = value.toObject();
        if (accessor.contains(key("sparse")) || !accessor.contains(key("bufferView")))
            return badGltf("an accessor without plain values");
        const auto view = whole(accessor, "bufferView");
        const auto offset = whole(accessor, "byteOffset");
        const auto count = whole(accessor, "count");
        const double element = bytesOfComponent(accessor.value(key("componentType")).toInt())
                               * componentsOf(accessor.value(key("type")).toString());
        if (!view || !offset || !count || element == 0.0 || *view >= double(viewLengths.size()))
            return badGltf("an accessor that does not follow the format");
        const auto index = static_cast<int>(*view);
        const auto stride = whole(views.at(index).toObject(), "byteStride", element);
        if (!stride || *stride < element
            || (*count > 0.0
                && *offset + (*count - 1.0) * *stride + element
                       > viewLengths[static_cast<std::size_t>(index)]))
            return badGltf("truncated: an accessor reaches beyond its view");
    }
    return {};
}

Result<void> checkGltfJson(std::string_view json,
                           const std::optional<std::filesystem::path>& folder,
                           std::optional<double> binaryChunk)
{
    QJsonParseError error{};
    const auto document = QJsonDocument::fromJson(
        QByteArray::fromRawData(json.data(), static_cast<qsizetype>(json.size())), &error);
    if (!document.isObject())
        return badGltf("its JSON is broken at byte " + std::to_string(error.offset));
    const auto buffers = bufferLengths(document.object(), folder, binaryChunk);
    if (!buffers)
        return tl::unexpected(buffers.error());
    const auto views = viewLengths(document.object(), *buffers);
    if (!views)
        return tl::unexpected(views.error());
    return checkAccessors(document.object(), *views);
}

} // namespace

Result<void> checkGltf(std::string_view bytes, const std::filesystem::path& folder)
{
    return checkGltfJson(bytes, folder, std::nullopt);
}

Result<void> checkGlb(std::string_view bytes)
{
    constexpr std::size_t kHeader = 12;
    constexpr std::size_t kChunkHeader = 8;
    constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
    const auto word = [&](std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + at, sizeof value);
        return value;
    };
    if (bytes.size() < kHeader + kChunkHeader || !bytes.starts_with("glTF"))
        return badGltf("it does not begin like a GLB");
    if (word(4) != 2)
        return badGltf("GLB version " + std::to_string(word(4)) + " instead of 2");
    if (word(8) != bytes.size())
        return badGltf("truncated: " + std::to_string(word(8)) + " bytes declared, "
                       + std::to_string(bytes.size()) + " there");
    const std::size_t jsonLength = word(12);
    const std::size_t binaryAt = kHeader + kChunkHeader + jsonLength;
    if (word(16) != kJsonChunk || binaryAt > bytes.size())
        return badGltf("its first chunk is not whole JSON");
    std::optional<double> binary;
    if (binaryAt + kChunkHeader <= bytes.size()) {
        binary = word(binaryAt);
        if (binaryAt + kChunkHeader + word(binaryAt) > bytes.size())
            return badGltf("truncated: its binary chunk is not there whole");
    }
    return checkGltfJson(bytes.substr(kHeader + kChunkHeader, jsonLength), std::nullopt, binary);
}

} // namespace carina
