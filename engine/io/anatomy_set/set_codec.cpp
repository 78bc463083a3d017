#include "engine/io/anatomy_set/set_codec.h"

#include "engine/io/mesh/mesh_codec.h"

#include <QCryptographicHash>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace carina
{
namespace
{

constexpr std::uint64_t kMagic = 0x5450414e49524143; // "CARINAPT"
/// Raised when the layout changes, or what an import makes of the same files.
constexpr std::uint32_t kVersion = 7;
constexpr std::size_t kHashBytes = 32;
constexpr std::uint32_t kMostLevels = 16;    ///< of one part
constexpr std::uint32_t kMostItems = 32'768; ///< of any other list; a part's number has 16 bits

QByteArray hashOfPayload(std::span<const std::byte> payload)
{
    QCryptographicHash hash{QCryptographicHash::Blake2b_256};
    hash.addData(QByteArrayView{payload.data(), static_cast<qsizetype>(payload.size())});
    return hash.result();
}

void writePoint(ByteWriter& writer, const Vec3& p)
{
    for (int axis = 0; axis < 3; ++axis)
        writer.real(p[axis]);
}

Vec3 readPoint(ByteReader& reader)
{
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis)
        p[axis] = reader.realDouble();
    reader.require(p.allFinite(), "a point is finite");
    return p;
}

template <class Items, class WriteItem>
void writeList(ByteWriter& writer, const Items& items, const WriteItem& writeItem)
{
    writer.number(static_cast<std::uint32_t>(items.size()));
    for (const auto& item : items)
        writeItem(writer, item);
}

/// Grows by one item for each that is there: a false count reads on into the end. An item may be
/// many times as large as the bytes that stand for it, so there is a most.
template <class Item, class ReadItem>
std::vector<Item> readList(ByteReader& reader, std::uint32_t most, const ReadItem& readItem)
{
    std::vector<Item> items;
    auto left = reader.number<std::uint32_t>();
    reader.require(left <= most, "a count within its limit");
    for (; left > 0 && reader.ok(); --left)
        items.push_back(readItem(reader));
    return items;
}

void writePart(ByteWriter& writer, const AnatomyPart& part)
{
    writeText(writer, part.name);
    writeText(writer, roleName(part.role));
    writeText(writer, part.conceptId);
    writeList(writer, part.levels, writeMesh);
    writeList(writer, part.deviations, [](ByteWriter& to, double d) { to.real(d); });
    writeList(writer, part.colors, writeColors);
}

double readDeviation(ByteReader& reader)
{
    const double deviation = reader.realDouble();
    reader.require(deviation >= 0.0 && std::isfinite(deviation), "a deviation is a length");
    return deviation;
}

AnatomyPart readPart(ByteReader& reader)
{
    AnatomyPart part;
    part.name = readText(reader);
    const std::optional<PartRole> role = roleFromName(readText(reader));
    reader.require(role.has_value(), "a part has a known role");
    part.role = role.value_or(PartRole::Other);
    part.conceptId = readText(reader);
    part.levels = readList<TriangleMesh>(reader, kMostLevels, readMesh);
    reader.require(!part.levels.empty(), "a part has a surface");
    part.deviations = readList<double>(reader, kMostLevels, readDeviation);
    reader.require(part.deviations.empty() || part.deviations.size() == part.levels.size(),
                   "a level has a deviation");
    std::size_t level = 0;
    part.colors = readList<std::vector<Rgb>>(reader, kMostLevels, [&](ByteReader& from) {
        const std::size_t at = level++;
        return readColors(from, at < part.levels.size() ? part.levels[at].positions.size() : 0);
    });
    reader.require(part.colors.empty() || part.colors.size() == part.levels.size(),
                   "a level has its colours");
    return part;
}

void writeFault(ByteWriter& writer, const FileFault& fault)
{
    writeText(writer, fault.file);
    writeFileError(writer, fault.error);
}

FileFault readFault(ByteReader& reader)
{
    std::string file = readText(reader);
    return {std::move(file), readFileError(reader)};
}

void writeFrame(ByteWriter& writer, const SetFrame& frame)
{
    writer.real(frame.metresPerUnit);
    for (int axis = 0; axis < 3; ++axis)
        writePoint(writer, frame.R_AF.col(axis));
}

SetFrame readFrame(ByteReader& reader)
{
    SetFrame frame;
    frame.metresPerUnit = reader.realDouble();
    for (int axis = 0; axis < 3; ++axis)
        frame.R_AF.col(axis) = readPoint(reader);
    return frame;
}

std::vector<std::byte> payloadOf(const ImportedSet& set)
{
    std::vector<std::byte> bytes;
    ByteWriter writer{bytes};
    writeText(writer, set.anatomy.name);
    writeText(writer, set.anatomy.contentHash);
    writeFrame(writer, set.frame);
    writePoint(writer, set.anatomy.landmarks.p_A_incisors);
    writePoint(writer, set.anatomy.landmarks.p_A_glottis);
    writePoint(writer, set.anatomy.landmarks.p_A_carina);
    writeList(writer, set.anatomy.landmarks.path_A, writePoint);
    writeList(writer, set.anatomy.parts, writePart);
    writeList(writer, set.anatomy.attributions, writeText);
    writeList(writer, set.faults, writeFault);
    writeList(writer, set.leftOut, writeText);
    return bytes;
}

ImportedSet readPayload(ByteReader& reader)
{
    ImportedSet set;
    set.anatomy.name = readText(reader);
    set.anatomy.contentHash = readText(reader);
    set.frame = readFrame(reader);
    set.anatomy.landmarks.p_A_incisors = readPoint(reader);
    set.anatomy.landmarks.p_A_glottis = readPoint(reader);
    set.anatomy.landmarks.p_A_carina = readPoint(reader);
    set.anatomy.landmarks.path_A = readList<Vec3>(reader, kMostItems, readPoint);
    set.anatomy.parts = readList<AnatomyPart>(reader, kMostItems, readPart);
    set.anatomy.attributions = readList<std::string>(reader, kMostItems, readText);
    set.faults = readList<FileFault>(reader, kMostItems, readFault);
    set.leftOut = readList<std::string>(reader, kMostItems, readText);
    reader.require(reader.remaining() == 0, "nothing follows");
    return set;
}

} // namespace

std::vector<std::byte> encodeSet(const ImportedSet& set)
{
    const std::vector<std::byte> payload = payloadOf(set);
    std::vector<std::byte> bytes;
    ByteWriter writer{bytes};
    writer.number(kMagic);
    writer.number(kVersion);
    writer.number(static_cast<std::uint64_t>(payload.size()));
    const QByteArray hash = hashOfPayload(payload);
    writer.bytes(std::as_bytes(std::span{hash.constData(), kHashBytes}));
    writer.bytes(payload);
    return bytes;
}

Result<ImportedSet> decodeSet(std::span<const std::byte> bytes)
{
    ByteReader reader{bytes};
    reader.require(reader.number<std::uint64_t>() == kMagic, "its first bytes");
    reader.require(reader.number<std::uint32_t>() == kVersion, "its version");
    const auto length = reader.number<std::uint64_t>();
    const auto hash = reader.bytes(kHashBytes);
    reader.require(length == reader.remaining(), "its length");
    const auto payload = reader.bytes(reader.remaining());
    if (reader.ok()) {
        const QByteArray expected = hashOfPayload(payload);
        const auto expectedBytes = std::as_bytes(std::span{expected.constData(), kHashBytes});
        reader.require(std::ranges::equal(hash, expectedBytes), "its checksum");
    }
    if (!reader.ok())
        return fail(Errc::FileMalformed, reader.brokenRule());
    ByteReader content{payload};
    ImportedSet set = readPayload(content);
    if (!content.ok())
        return fail(Errc::FileMalformed, content.brokenRule());
    return set;
}

} // namespace carina
