#pragma once

#include "engine/anatomy/laryngoscopy/seen_structure.h"
#include "engine/geometry/rigid_transform.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace carina
{

/// What is seen in each pixel of a picture.
struct StructurePicture {
    int width = 0;
    int height = 0;
    std::vector<SeenStructure> pixels{}; ///< row by row from the top
};

/// A camera D (+x right, +y up, looking along -z) whose line of sight is in the middle of its
/// picture, and the tangents of half its angles of view.
struct PictureCamera {
    RigidTransform X_AD;
    double halfWidth = 1.0;
    double halfHeight = 1.0;
};

/// The glottis as a line, in A.
struct GlotticLine {
    Vec3 p_A_commissure = Vec3::Zero(); ///< anterior
    Vec3 p_A_notch = Vec3::Zero();      ///< interarytenoid
};

/// The view of the larynx, after Cormack and Lehane (Anaesthesia 1984;39:1105), with grade 2
/// divided after Yentis and Lee (Anaesthesia 1998;53:1041).
enum class CormackLehane : std::uint8_t {
    Grade1,  ///< most of the glottis
    Grade2a, ///< a part of the glottis
    Grade2b, ///< arytenoids, or the very end of the glottis behind
    Grade3,  ///< of the larynx the epiglottis only
    Grade4,  ///< not even that
};

/// "1", "2a", "2b", "3" or "4".
[[nodiscard]] const char* gradeName(CormackLehane grade);

/// What a picture shows of the larynx.
struct GlotticView {
    /// Percentage of glottic opening, as a share: the part that is seen of the line from the
    /// anterior commissure to the interarytenoid notch (Levitan et al., Acad Emerg Med 1998;5:919).
    double opening = 0.0;
    double underTube = 0.0; ///< the share of that line that a tube covers; the rest is measured
    double empty = 0.0;     ///< the share of the picture in which no structure is seen
    CormackLehane grade = CormackLehane::Grade4;
    std::array<std::size_t, kSeenStructures> visiblePixels{}; ///< by SeenStructure

    /// Whether so little is covered by a tube that the rest tells of the whole, and the picture is
    /// not that of a camera which is inside something, the tube for instance.
    [[nodiscard]] bool isTelling() const
    {
        return underTube <= kMostUnderTube && empty <= kMostEmpty;
    }
    static constexpr double kMostUnderTube = 0.5; ///< of ours
    static constexpr double kMostEmpty = 0.6;     ///< likewise
};

/// Above this share of the glottis a view counts as grade 1, "most of the glottis".
inline constexpr double kMostOfGlottis = 0.5;
/// Up to this share only its end behind is seen, as of grade 2b: of ours.
inline constexpr double kEndOfGlottis = 0.1;
/// A structure counts as seen from this share of a picture on: of ours, 0.05 % (154 pixels of
/// 640 x 480).
inline constexpr double kLeastSeen = 5e-4;

/// The share of a line that is seen: of kLineSamples points of it, in equal distances, those inside
/// the picture in whose pixel nothing is seen that hides the glottis (hidesGlottis). Points that
/// a tube covers are not counted at all; 0 where it covers all.
/// @pre the picture has width * height pixels
[[nodiscard]] double seenShare(const StructurePicture& picture, const PictureCamera& camera,
                               const GlotticLine& line);
inline constexpr int kLineSamples = 101;

/// Measures a picture.
/// @pre the same
[[nodiscard]] GlotticView glotticView(const StructurePicture& picture, const PictureCamera& camera,
                                      const GlotticLine& line);

} // namespace carina
