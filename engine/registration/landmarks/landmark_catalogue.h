#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/vec.h"

#include <string>
#include <vector>

namespace carina
{

/// A place that can be found on the manikin and whose position in the virtual patient is known.
struct Landmark {
    std::string name;         ///< as shown: "Sternal notch"
    Vec3 p_AQ = Vec3::Zero(); ///< in the anatomy frame A, metres

    friend bool operator==(const Landmark&, const Landmark&) = default;
};

/// The landmarks of one virtual patient, in the order in which they are touched. The first three
/// define the axes of the manikin's local frame (see siteFrame).
struct LandmarkCatalogue {
    std::string name;    ///< as shown: "Rib cage"
    std::string anatomy; ///< content hash of the patient; empty where none is specified
    std::vector<Landmark> landmarks;

    friend bool operator==(const LandmarkCatalogue&, const LandmarkCatalogue&) = default;
};

/// Whether a catalogue is valid for touching and fitting.
/// @returns TooFewLandmarks below three; OutOfRange where a name is missing or occurs twice;
///          NotFinite or OutOfRange for an invalid position. The detail names the landmark.
[[nodiscard]] Result<void> checkCatalogue(const LandmarkCatalogue& catalogue);

/// The four landmarks of 2004 on the rib cage, for a patient without bones: sternal notch, tip of
/// the xiphoid process, left and right fifth rib on the midclavicular line. Their positions
/// relative to the carina are shares of the body's height; landmark_catalogue.cpp gives the source.
[[nodiscard]] LandmarkCatalogue ribCageCatalogue(Length height, std::string anatomy);

/// Further places for landmarks, with the mouth closed; in A, metres. The angles of the jaw lie
/// around glottis and teeth, where the four on the rib cage leave the largest error, the tenth ribs
/// at the bases of the lungs.
struct FurtherPlaces {
    Vec3 p_A_leftJawAngle = Vec3::Zero();
    Vec3 p_A_rightJawAngle = Vec3::Zero();
    Vec3 p_A_leftTenthRib = Vec3::Zero(); ///< end of the bone, at the edge of the rib cage
    Vec3 p_A_rightTenthRib = Vec3::Zero();
};

/// These places as shares of the body's height, as in ribCageCatalogue.
[[nodiscard]] FurtherPlaces furtherPlaces(Length height);

/// The four landmarks of a rib cage and the four further ones. The first six already surround the
/// glottis; docs/registration.md tells how much each pair reduces the error.
/// @param ribCage the result of ribCageCatalogue or boneLandmarks
[[nodiscard]] LandmarkCatalogue ribCageAndJawCatalogue(LandmarkCatalogue ribCage,
                                                       const FurtherPlaces& further);

} // namespace carina
