#include "models/registration_words.h"

#include "models/registration_model.h"

#include <QCoreApplication>

namespace carina
{
namespace
{

class RegistrationWords
{
    Q_DECLARE_TR_FUNCTIONS(RegistrationWords)

public:
    static QString tracker(const RegistrationModel& model)
    {
        return model.isDone(SiteStep::Tracker)
                   ? tr("The %1 is in use. Go on to the stylus.").arg(model.trackerName())
                   : tr("See that stylus and chin probe are visible, then use this tracker.");
    }

    static QString stylus(const RegistrationModel& model)
    {
        if (model.isSwinging())
            return tr("Keep the tip in the divot and swing the stylus slowly to all sides.");
        if (const auto& stylus = model.site().stylus)
            return tr("The tip is %1 mm from the markers; it stayed within %2 mm (RMS) of its "
                      "divot. Go on, or swing again.")
                .arg(1e3 * stylus->p_SQ.norm(), 0, 'f', 1)
                .arg(1e3 * stylus->rms, 0, 'f', 2);
        return tr("Set the stylus's tip into a divot that does not move, then start swinging.");
    }

    static QString landmarks(const RegistrationModel& model)
    {
        const auto next = model.nextLandmark();
        return tr("Use these landmarks, or choose one and click on the model where it shall be%1.")
            .arg(next ? tr(" (now: %1)").arg(model.landmarks()[*next].name) : QString{});
    }

    static QString touch(const RegistrationModel& model)
    {
        const auto next = model.nextLandmark();
        if (next)
            return tr("Touch this place on the manikin and hold still for a second: %1.")
                .arg(model.landmarks()[*next].name);
        return tr("All landmarks are touched. Go on to the fit, or choose one to touch again.");
    }

    static QString fit(const RegistrationModel& model)
    {
        if (const auto& registration = model.site().registration)
            return tr("Fitted: the landmarks stay %1 mm (RMS) from their places. Touch one with a "
                      "much longer bar again.")
                .arg(1e3 * registration->rms, 0, 'f', 1);
        return tr("Close the manikin's mouth, then fit the anatomy to the touched landmarks.");
    }

    static QString missingFor(SiteStep step, const RegistrationModel& model)
    {
        const Site& site = model.site();
        if (step != SiteStep::Tracker && !model.isDone(SiteStep::Tracker))
            return tr("Choose the tracker first.");
        if (step == SiteStep::Touch && !site.stylus)
            return tr("Find the tip of the stylus first.");
        if (step == SiteStep::Touch && !site.catalogue)
            return tr("Choose the landmarks first.");
        if (step == SiteStep::Fit && !model.isDone(SiteStep::Touch))
            return tr("Touch all landmarks first.");
        if (step == SiteStep::Verify && !site.registration)
            return tr("Fit the anatomy first.");
        return {};
    }

    static QString verify()
    {
        return tr("Touch places that you know on the manikin and compare: the stylus has to be "
                  "where you see it on the anatomy.");
    }
};

} // namespace

QString registrationInstruction(const RegistrationModel& model)
{
    switch (model.step()) {
    case SiteStep::Tracker:
        return RegistrationWords::tracker(model);
    case SiteStep::Stylus:
        return RegistrationWords::stylus(model);
    case SiteStep::Landmarks:
        return RegistrationWords::landmarks(model);
    case SiteStep::Touch:
        return RegistrationWords::touch(model);
    case SiteStep::Fit:
        return RegistrationWords::fit(model);
    case SiteStep::Verify:
        return RegistrationWords::verify();
    }
    return {};
}

QString whyNotYet(const RegistrationModel& model, SiteStep step)
{
    return RegistrationWords::missingFor(step, model);
}

} // namespace carina
