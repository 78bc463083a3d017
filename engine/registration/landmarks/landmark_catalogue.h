#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/vec.h"

#include <string>
#include <vector>

namespace carina
{

/// A place that can be found on the manikin and is known in the virtual patient.
struct Landmark {
    std::string name;         ///< as shown: "Sternal notch"
    Vec3 p_AQ = Vec3::Zero(); ///< in the anatomy frame A, metres

    friend bool operator==(const Landmark&, const Landmark&) = default;
};

/// The landmarks of one virtual patient, in the order in which they are touched. The first three
/// make the manikin's local frame (see siteFrame).
struct LandmarkCatalogue {
    std::string name;    ///< as shown: "Rib cage"
    std::string anatomy; ///< content hash of the patient they are of; empty where none is named
    std::vector<Landmark> landmarks;

    friend bool operator==(const LandmarkCatalogue&, const LandmarkCatalogue&) = default;
};

/// Whether a catalogue can be touched and fitted.
/// @returns TooFewLandmarks below three; OutOfRange where a name is missing or there twice;
///          NotFinite or OutOfRange for a position that is not one. The detail names the landmark.
[[nodiscard]] Result<void> checkCatalogue(const LandmarkCatalogue& catalogue);

/// The four landmarks of 2004 on the rib cage of a patient without bones: sternal notch, tip of the
/// xiphoid process, left and right fifth rib on the mid-clavicular line. Their places relative to
/// the carina are shares of the body's height; landmark_catalogue.cpp gives their source.
[[nodiscard]] LandmarkCatalogue ribCageCatalogue(Length height, std::string anatomy);

/// Places beyond the four, with the mouth shut. Those on the jaw lie around glottis and teeth,
/// where the rib cage alone leaves the largest error; those on the tenth ribs at the bases of the
/// lungs.
struct FurtherPlaces {
    Vec3 p_A_leftJawAngle = Vec3::Zero();
    Vec3 p_A_rightJawAngle = Vec3::Zero();
    Vec3 p_A_leftTenthRib = Vec3::Zero(); ///< where its bone ends, at the edge of the rib cage
    Vec3 p_A_rightTenthRib = Vec3::Zero();
};

/// By proportions of the body, as ribCageCatalogue.
[[nodiscard]] FurtherPlaces furtherPlaces(Length height);

/// The four of a rib cage and the further ones: eight landmarks, of which the first six already
/// surround the glottis (docs/registration.md has what each adds).
/// @param ribCage of ribCageCatalogue or boneLandmarks
[[nodiscard]] LandmarkCatalogue ribCageAndJawCatalogue(LandmarkCatalogue ribCage,
                                                       const FurtherPlaces& further);

} // namespace carina
