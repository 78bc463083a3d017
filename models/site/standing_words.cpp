#include "models/site/standing_words.h"

#include <QCoreApplication>

namespace carina
{
namespace
{

class StandingWords
{
    Q_DECLARE_TR_FUNCTIONS(RegistrationStanding)

public:
    static QString number(Length error, int decimals)
    {
        return QString::number(inMillimetres(error), 'f', decimals);
    }

    /// The words, and a known error after them.
    static QString withError(const QString& words, Length error)
    {
        return error.si > 0.0 ? tr("%1, %2\u00a0mm").arg(words, number(error, 1)) : words;
    }

    static QString staleText(const RegistrationStanding& standing)
    {
        switch (standing.reason) {
        case StaleReason::Tracker:
            return tr("▲ stale: tracker changed");
        case StaleReason::Stylus:
            return tr("▲ stale: stylus calibrated anew");
        case StaleReason::Landmarks:
            return tr("▲ stale: landmarks changed");
        case StaleReason::Manikin:
            return tr("▲ stale: manikin moved");
        case StaleReason::Touches:
            return tr("▲ stale: landmarks touched anew");
        case StaleReason::Patient:
            return tr("▲ stale: another patient");
        case StaleReason::Registering:
            return tr("▲ stale: being registered again");
        case StaleReason::Age:
            return tr("▲ stale: verified long ago");
        case StaleReason::Drift:
            return tr("▲ stale: moved by about %1\u00a0mm").arg(number(standing.error, 0));
        case StaleReason::Fit:
        case StaleReason::None:
            break;
        }
        return tr("▲ stale");
    }

    static QString staleNotice(const RegistrationStanding& standing)
    {
        switch (standing.reason) {
        case StaleReason::Tracker:
            return tr("The manikin was registered before the tracker, or one of its devices, was "
                      "changed: register it again");
        case StaleReason::Stylus:
            return tr("The registration is out of date, because the stylus was calibrated anew: "
                      "touch the landmarks again");
        case StaleReason::Landmarks:
            return tr("The registration is out of date, because landmarks were changed: touch "
                      "these and fit the patient again");
        case StaleReason::Manikin:
            return tr("The registration is out of date, because the manikin was moved: touch its "
                      "landmarks and fit the patient again");
        case StaleReason::Touches:
            return tr("The registration is out of date, because landmarks were touched again: fit "
                      "the patient");
        case StaleReason::Patient:
            return tr("The manikin is registered for another patient: register it for this one");
        case StaleReason::Registering:
            return tr("The manikin is being registered again: finish that");
        case StaleReason::Age:
            return tr("The registration was verified more than 30 days ago: verify two points");
        case StaleReason::Drift:
            return tr("The manikin has moved by about %1\u00a0mm since it was registered: register "
                      "it again")
                .arg(number(standing.error, 0));
        case StaleReason::Fit:
        case StaleReason::None:
            break;
        }
        return tr("The registration is out of date: register the manikin again");
    }
};

} // namespace

QString standingText(const RegistrationStanding& standing)
{
    switch (standing.state) {
    case RegistrationState::Simulated:
        return StandingWords::tr("✓ simulated");
    case RegistrationState::Good:
        return StandingWords::withError(StandingWords::tr("✓ registered"), standing.error);
    case RegistrationState::Unverified:
        return StandingWords::withError(StandingWords::tr("▲ unverified"), standing.error);
    case RegistrationState::NotGood:
        return standing.error.si > 0.0 ? StandingWords::tr("▲ not good: %1\u00a0mm at check")
                                             .arg(StandingWords::number(standing.error, 1))
                                       : StandingWords::tr("▲ not good");
    case RegistrationState::Stale:
        return StandingWords::staleText(standing);
    case RegistrationState::Missing:
        return StandingWords::tr("▲ not registered");
    case RegistrationState::NoTracker:
        return QStringLiteral("–");
    }
    return {};
}

QString standingNotice(const RegistrationStanding& standing)
{
    switch (standing.state) {
    case RegistrationState::Simulated:
    case RegistrationState::Good:
    case RegistrationState::NoTracker:
        break;
    case RegistrationState::Unverified:
        return StandingWords::tr("The registration is not verified: touch two points to verify it");
    case RegistrationState::NotGood:
        return standing.error.si > 0.0
                   ? StandingWords::tr("The registration was judged not good, %1\u00a0mm off at a "
                                       "check: touch the landmarks again")
                         .arg(StandingWords::number(standing.error, 1))
                   : StandingWords::tr("The registration was judged not good: touch the landmarks "
                                       "again");
    case RegistrationState::Stale:
        return StandingWords::staleNotice(standing);
    case RegistrationState::Missing:
        return StandingWords::tr("The manikin is not registered: register it with "
                                 "carina-registration");
    }
    return {};
}

} // namespace carina
