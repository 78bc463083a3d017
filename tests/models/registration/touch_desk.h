#pragma once

#include "tests/models/registration/registration_site.h"

#include <initializer_list>
#include <memory>
#include <vector>

namespace carina::test
{

inline constexpr double kExact = 1e-9; // m, of exact samples

/// A wizard whose stylus is known, on the page where landmarks are touched.
struct Desk {
    RegistrationSite site;
    std::unique_ptr<RegistrationModel> model = site.model();
    std::vector<Landmark> landmarks = site.landmarks();

    Desk()
    {
        model->useTracker();
        site.swing(*model);
        model->landmarkTask().accept();
    }

    void touch(std::size_t landmark, const RigidTransform& X_TA)
    {
        site.hold(*model, X_TA * landmarks[landmark].p_AQ);
    }
    void touch(std::size_t landmark) { touch(landmark, site.X_TA); }
    /// These, whatever is asked for.
    void touchChosen(std::initializer_list<std::size_t> chosen, const RigidTransform& X_TA)
    {
        for (const std::size_t landmark : chosen) {
            model->touching().choose(landmark);
            touch(landmark, X_TA);
        }
    }
    void register_()
    {
        for (std::size_t i = 0; i < landmarks.size(); ++i)
            touch(i);
        model->enter(SiteStep::Fit);
        model->fitting().fit();
    }
    [[nodiscard]] bool isTouched(std::size_t landmark) const
    {
        return model->landmarks()[landmark].spread_mm.has_value();
    }
};

/// Where somebody pushed the manikin to: X_T'A of a push and the place from before.
inline RigidTransform pushed(const RigidTransform& X_TA)
{
    return RigidTransform{rotationFromVector({0.05, -0.3, 0.1}), {0.04, -0.02, 0.03}} * X_TA;
}

inline bool liesAt(const RegistrationModel& model, const RigidTransform& X_TA)
{
    return (model.site().registration->X_AT * X_TA).matrix().isApprox(Mat4::Identity(), kExact);
}

} // namespace carina::test
