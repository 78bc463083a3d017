#include "apps/lab/vision/accuracy_figures.h"

#include "engine/core/units.h"

namespace carina::lab
{
namespace
{

namespace seen_key
{
constexpr Key kDistance{"distance_mm", "of the body's origin from the camera", 1};
constexpr Key kPoses{"poses", "that were looked for", 1};
constexpr Key kSeen{"seen", "of these, with a pose that is given", 1};
constexpr Key kAmbiguous{"ambiguous", "of these, two poses fit: none is given", 1};
constexpr Key kWrong{"wrong", "of those given, off by more than 10 degrees; not in what follows",
                     1};
constexpr Key kAcross{"across_mm",
                      "error of the position along each axis across the line of sight, "
                      "RMS",
                      1};
constexpr Key kAlong{"along_mm", "error of it along the line of sight, RMS", 1};
constexpr Key kRotation{"rotation_deg", "error of the rotation, RMS", 1};
constexpr Key kReprojection{"reprojection_px", "distance of corners from the pose's, RMS", 1};
constexpr Key kNormalised{"normalised_square",
                          "squared error over the stated covariance, for each of six degrees of "
                          "freedom, mean: 1 where the covariance is right",
                          1};
} // namespace seen_key

} // namespace

QJsonObject accuracyFigures(const MarkerAccuracy& accuracy)
{
    return {{seen_key::kDistance, 1e3 * accuracy.distance},
            {seen_key::kPoses, accuracy.poses},
            {seen_key::kSeen, accuracy.seen},
            {seen_key::kAmbiguous, accuracy.ambiguous},
            {seen_key::kWrong, accuracy.wrong},
            {seen_key::kAcross, 1e3 * accuracy.acrossRms},
            {seen_key::kAlong, 1e3 * accuracy.alongRms},
            {seen_key::kRotation, inDegrees(radians(accuracy.rotationRms))},
            {seen_key::kReprojection, accuracy.reprojectionRms},
            {seen_key::kNormalised, accuracy.normalisedSquare}};
}

std::vector<Key> withAccuracyKeys(std::vector<Key> keys)
{
    for (const Key& key :
         {seen_key::kDistance, seen_key::kPoses, seen_key::kSeen, seen_key::kAmbiguous,
          seen_key::kWrong, seen_key::kAcross, seen_key::kAlong, seen_key::kRotation,
          seen_key::kReprojection, seen_key::kNormalised})
        keys.push_back(key);
    return keys;
}

} // namespace carina::lab
