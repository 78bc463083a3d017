#pragma once

#include "engine/registration/landmarks/landmark_catalogue.h"

#include <vector>

namespace carina::test
{

/// The eight landmarks of the catalogue of a patient of 1.75 m, in A.
inline std::vector<Vec3> eightOfTheCatalogue()
{
    std::vector<Vec3> places;
    const Length height = metres(1.75);
    for (const Landmark& landmark :
         ribCageAndJawCatalogue(ribCageCatalogue(height, {}), furtherPlaces(height)).landmarks)
        places.push_back(landmark.p_AQ);
    return places;
}

} // namespace carina::test
