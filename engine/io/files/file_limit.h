#pragma once

#include "engine/core/result.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace carina
{

/// The most that is read of one kind of file. A larger file is refused before any of it is read.
struct FileLimit {
    const char* kind; ///< as an error names it, with its article
    std::uint64_t mostBytes;

    friend bool operator==(const FileLimit&, const FileLimit&) = default;
};

constexpr std::uint64_t kMebibyte = std::uint64_t{1} << 20U;

/// OBJ, PLY, STL, glTF and GLB, and the buffers of a glTF.
inline constexpr FileLimit kSurfaceLimit{"a surface", 1024 * kMebibyte};
/// PNG and JPEG files that a surface refers to.
inline constexpr FileLimit kPictureLimit{"a picture", 256 * kMebibyte};
/// MTL files.
inline constexpr FileLimit kMaterialLimit{"a material", 16 * kMebibyte};
/// JSON files: sites, manikins, catalogues of landmarks, corrections; and lists of landmarks,
/// manifests and notes beside surfaces.
inline constexpr FileLimit kDescriptionLimit{"a description", 16 * kMebibyte};
/// What a tracker has to know of a tool: .rom files, of 752 bytes.
inline constexpr FileLimit kDefinitionLimit{"a tool definition", kMebibyte / 16};
/// Certificates, private keys, join codes and tokens.
inline constexpr FileLimit kCredentialLimit{"a certificate, key or code", kMebibyte};
/// Tables and recordings that are measured with: CSV, configurations, waveforms, traces.
inline constexpr FileLimit kMeasurementLimit{"a measurement", 1024 * kMebibyte};
/// A patient that travels between computers.
inline constexpr FileLimit kCarriedSetLimit{"a patient of another computer", 256 * kMebibyte};
/// An imported patient in the cache.
inline constexpr FileLimit kCachedSetLimit{"an imported patient", 4096 * kMebibyte};

/// @returns FileTooLarge where `bytes` are more than the limit; the detail begins with the file and
///          says both sizes.
[[nodiscard]] Result<void> checkSize(const std::filesystem::path& file, std::uint64_t bytes,
                                     const FileLimit& limit);

/// The size of a file that may be read: a regular one, not empty and within its limit.
/// @returns FileNotFound; FileUnreadable (also for a folder or a device); FileEmpty; FileTooLarge.
///          The detail begins with the file.
[[nodiscard]] Result<std::uint64_t> readableSize(const std::filesystem::path& file,
                                                 const FileLimit& limit);

} // namespace carina
