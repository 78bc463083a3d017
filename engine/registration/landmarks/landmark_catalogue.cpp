#include "engine/registration/landmarks/landmark_catalogue.h"

#include "engine/geometry/fit/point_check.h"

#include <set>
#include <utility>

namespace carina
{
namespace
{

// Measured on the bones of BodyParts3D's adult man, whose skull ends 1.64 m above its zero and who
// is taken for 1.65 m tall: the notch of the manubrium is 57 mm before and 34 mm above the carina,
// the tip of the xiphoid process 124 mm before and 124 mm below it, the front of the fifth ribs
// 116 mm before and 105 mm below it under the middle of the clavicle, 76 mm from the midline.
const Vec3 kSternalNotch{0.0, -0.0345, 0.0206};
const Vec3 kXiphoidProcess{0.0, -0.0752, -0.0752};
const Vec3 kLeftFifthRib{0.0461, -0.0703, -0.0636};
const Vec3 kRightFifthRib{-0.0461, -0.0703, -0.0636};

// The tenth ribs of the same man end 35 mm before and 254 mm below the carina, 116 mm from the
// midline. The angles of the jaw are those of the built-in man of 1.75 m with his mouth shut: 52 mm
// from the midline, 17 mm before and 175 mm above the carina.
const Vec3 kLeftTenthRib{0.0703, -0.0209, -0.1542};
const Vec3 kLeftJawAngle{0.0298, -0.0099, 0.0998};

Vec3 onOtherSide(const Vec3& p_A) { return {-p_A.x(), p_A.y(), p_A.z()}; }

} // namespace

Result<void> checkCatalogue(const LandmarkCatalogue& catalogue)
{
    if (catalogue.landmarks.size() < 3)
        return fail(Errc::TooFewLandmarks, std::to_string(catalogue.landmarks.size())
                                               + " landmarks, and 3 are the fewest");
    std::set<std::string> names;
    for (const Landmark& landmark : catalogue.landmarks) {
        if (landmark.name.empty())
            return fail(Errc::OutOfRange, "a landmark has no name");
        if (!names.insert(landmark.name).second)
            return fail(Errc::OutOfRange, "\"" + landmark.name + "\" is there twice");
        if (const auto sound = checkPoint(landmark.p_AQ, landmark.name.c_str()); !sound)
            return sound;
    }
    return {};
}

LandmarkCatalogue ribCageCatalogue(Length height, std::string anatomy)
{
    return {"Rib cage",
            std::move(anatomy),
            {{"Sternal notch", height.si * kSternalNotch},
             {"Xiphoid process", height.si * kXiphoidProcess},
             {"Left fifth rib, mid-clavicular line", height.si * kLeftFifthRib},
             {"Right fifth rib, mid-clavicular line", height.si * kRightFifthRib}}};
}

FurtherPlaces furtherPlaces(Length height)
{
    return {height.si * kLeftJawAngle, height.si * onOtherSide(kLeftJawAngle),
            height.si * kLeftTenthRib, height.si * onOtherSide(kLeftTenthRib)};
}

LandmarkCatalogue ribCageAndJawCatalogue(LandmarkCatalogue ribCage, const FurtherPlaces& further)
{
    ribCage.name = "Rib cage and jaw";
    ribCage.landmarks.push_back({"Left angle of the jaw", further.p_A_leftJawAngle});
    ribCage.landmarks.push_back({"Right angle of the jaw", further.p_A_rightJawAngle});
    ribCage.landmarks.push_back({"End of the left tenth rib", further.p_A_leftTenthRib});
    ribCage.landmarks.push_back({"End of the right tenth rib", further.p_A_rightTenthRib});
    return ribCage;
}

} // namespace carina
