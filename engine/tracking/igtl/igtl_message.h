#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace carina
{

// What messages of OpenIGTLink contain, as they have it: millimetres, single precision. Poses of
// the engine are made of them in igtl_pose.h.

/// Three columns of a rotation, then the position.
using IgtlMatrix = std::array<float, 12>;

struct IgtlTransform {
    IgtlMatrix matrix{};
};

struct IgtlPosition {
    std::array<float, 3> p{};
    std::array<float, 4> q{}; ///< x y z w
    /// How many of q are there: 4, 3 (then w follows from the unit length) or none.
    int terms = 4;
};

/// One tool of TDATA.
struct IgtlTracked {
    std::string name;
    std::uint8_t type = 1; ///< 1 tracker, 2 6D instrument, 3 3D instrument, 4 5D instrument
    IgtlMatrix matrix{};
};
struct IgtlTrackingData {
    std::vector<IgtlTracked> tools;
};

/// One tool of QTDATA.
struct IgtlQuaternionTracked {
    std::string name;
    std::uint8_t type = 1;
    std::array<float, 3> p{};
    std::array<float, 4> q{}; ///< x y z w
};
struct IgtlQuaternionTrackingData {
    std::vector<IgtlQuaternionTracked> tools;
};

/// STT_TDATA and STT_QTDATA: asks for all tools, again and again.
struct IgtlStart {
    bool asksQuaternions = false;
    std::int32_t interval_ms = 0;
    std::string frame; ///< in which poses are asked for
};

struct IgtlStatus {
    std::uint16_t code = 1; ///< 1 means OK
    std::int64_t subcode = 0;
    std::string name;
    std::string text;
};

struct IgtlString {
    std::uint16_t encoding = 3; ///< number of IANA; 3: ASCII
    std::string text;
};

/// POINT: named places, as landmarks are.
struct IgtlPoint {
    std::string name;
    std::string group;
    std::array<std::uint8_t, 4> rgba{255, 255, 255, 255};
    std::array<float, 3> p{};
    float diameter = 0.0F;
    std::string owner;
};
struct IgtlPoints {
    std::vector<IgtlPoint> points;
};

/// Cells of a surface, as they travel: the number of corners of each, then its corners.
struct IgtlCells {
    std::uint32_t count = 0;
    std::vector<std::uint32_t> numbers;
};
struct IgtlAttribute {
    std::uint8_t type = 0;
    std::uint8_t components = 1;
    std::uint32_t count = 0;
    std::string name;
    std::vector<float> values; ///< count times components
};
struct IgtlPolyData {
    std::vector<std::array<float, 3>> points;
    std::array<IgtlCells, 4> cells; ///< vertices, lines, polygons, triangle strips
    std::vector<IgtlAttribute> attributes;
};
inline constexpr std::size_t kIgtlPolygons = 2; ///< in IgtlPolyData::cells

/// GET_... and STP_...: asks once, or asks to stop; without content.
struct IgtlQuery {
    std::string type;
};
/// RTS_...: the reply to a query, whether it is followed.
struct IgtlReply {
    std::string type;
    std::int8_t status = 0; ///< 0: it is
};
/// A message of a type that is not read.
struct IgtlSkipped {
    std::string type;
};

using IgtlContent = std::variant<IgtlTransform, IgtlPosition, IgtlTrackingData,
                                 IgtlQuaternionTrackingData, IgtlStart, IgtlStatus, IgtlString,
                                 IgtlPoints, IgtlPolyData, IgtlQuery, IgtlReply, IgtlSkipped>;

/// A word about a message, of protocol 3.
struct IgtlMetadata {
    std::string key;
    std::uint16_t encoding = 3;
    std::string value;
};

struct IgtlMessage {
    std::uint16_t version = 1; ///< of the header; 2 has an id and metadata (protocol 3)
    std::string device{};      ///< at most 20 characters
    std::uint64_t stamp = 0;   ///< seconds since 1970 (UTC) times 2^32; 0: not stated
    std::uint32_t id = 0;
    std::vector<IgtlMetadata> metadata{};
    IgtlContent content{};
};

} // namespace carina
