#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/tracking/markers/probe.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carina
{

/// What a tracker of NDI has to know of a tool: the content of a .rom file, of 752 bytes.
///
/// Bytes whose meaning is not known are kept as they were read.
class NdiToolDefinition
{
public:
    static constexpr std::size_t kBytes = 752;
    static constexpr std::size_t kMostMarkers = 20;

    /// What a tool is for, as NDI numbers it.
    enum class Kind : std::uint8_t {
        Reference = 1,
        Pointer = 2,
        ButtonBox = 3,
        Software = 4,
        Microscope = 5,
        CalibrationDock = 8,
        CArm = 0xA,
        Catheter = 0xB,
    };

    /// What the tool is, and what is asked of its markers.
    struct Facts {
        std::uint8_t kind = 0; ///< a Kind, or another number that a file has
        std::string maker{};
        std::string partNumber{};
        std::uint32_t fewestMarkers = 3;              ///< that a pose needs
        Length largestMarkerError = millimetres(2.0); ///< of a marker that is used
        Length smallestSpread = millimetres(10.0);    ///< of the markers that are used
        Angle largestMarkerAngle = degrees(90.0);     ///< between its normal and the camera
    };

    /// Reads the bytes of a .rom file.
    /// @returns FileMalformed for another length, beginning, checksum, or number of markers;
    ///          NotFinite and OutOfRange for a marker that is not within 2 m; NotFinite for what is
    ///          asked of markers.
    [[nodiscard]] static Result<NdiToolDefinition> read(std::span<const std::byte> bytes);

    /// A tool of one face, of whose pose is asked what the probe asks.
    /// @returns TooFewLandmarks below three markers; OutOfRange for more than kMostMarkers and for
    ///          a marker that is not within 2 m; DegenerateLandmarks where they are on one line;
    ///          OutOfRange for what a file cannot state, as `with` does.
    [[nodiscard]] static Result<NdiToolDefinition>
    make(Kind kind, const Probe& probe, const std::string& maker, const std::string& partNumber);
    /// The same of markers alone: at least three are needed for a pose, which have to fit to 2 mm,
    /// and are seen up to 90 degrees from their normals.
    [[nodiscard]] static Result<NdiToolDefinition> make(Kind kind,
                                                        std::span<const ToolMarker> markers,
                                                        const std::string& maker,
                                                        const std::string& partNumber);

    /// The same tool with other facts; all other bytes stay as they were.
    /// @returns OutOfRange for one that is changed to a kind without a name, a maker of more than
    ///          12 or a part number of more than 20 plain characters, fewer markers than three or
    ///          more than there are, an error that is not above 0 and at most 100 mm, a spread that
    ///          is not 0 to 4 m, an angle that is not 1 to 180 whole degrees.
    [[nodiscard]] Result<NdiToolDefinition> with(const Facts& wanted) const;

    /// The same tool with one marker elsewhere; all that is said of the others stays as it was.
    /// @pre there is such a marker.
    /// @returns OutOfRange for a place that is not within 2 m; DegenerateLandmarks where three or
    ///          more markers would be on one line.
    [[nodiscard]] Result<NdiToolDefinition> withMarker(std::size_t marker, const Vec3& p_OQ) const;

    [[nodiscard]] std::uint8_t kind() const { return byteAt(15); }
    [[nodiscard]] std::vector<ToolMarker> markers() const;
    [[nodiscard]] std::uint32_t fewestMarkers() const; ///< that a pose needs
    [[nodiscard]] Length largestMarkerError() const;   ///< of a marker that is used
    [[nodiscard]] Length smallestSpread() const;
    [[nodiscard]] Angle largestMarkerAngle() const; ///< between its normal and the camera
    [[nodiscard]] Facts facts() const;
    /// Its markers, and what a pose asks of them.
    [[nodiscard]] Probe probe() const;
    [[nodiscard]] std::string maker() const;
    [[nodiscard]] std::string partNumber() const;

    /// As they are written to a file, with their checksum.
    [[nodiscard]] const std::array<std::byte, kBytes>& bytes() const { return m_bytes; }

private:
    NdiToolDefinition() = default;

    [[nodiscard]] std::uint8_t byteAt(std::size_t at) const;
    [[nodiscard]] std::uint32_t wholeAt(std::size_t at) const;
    [[nodiscard]] Vec3 vectorAt(std::size_t at) const;
    [[nodiscard]] std::string textAt(std::size_t at, std::size_t most) const;
    [[nodiscard]] std::uint16_t checksum() const;
    void putByte(std::size_t at, std::uint8_t value) { m_bytes[at] = std::byte{value}; }
    void putWhole(std::size_t at, std::uint32_t value);
    void putReal(std::size_t at, double value);
    void putVector(std::size_t at, const Vec3& vector);
    void putChecksum();
    void putText(std::size_t at, std::size_t most, const std::string& text);
    void putAsked(const Facts& facts);

    std::array<std::byte, kBytes> m_bytes{};
};

/// The name of a kind: "pointer"; "kind 7" for one that has none here.
[[nodiscard]] std::string kindName(std::uint8_t kind);
/// The kind of a name; nothing where it is none.
[[nodiscard]] std::optional<std::uint8_t> kindOfName(std::string_view name);
/// All names, separated by commas.
[[nodiscard]] std::string kindNames();

} // namespace carina
