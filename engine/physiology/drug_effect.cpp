#include "engine/physiology/drug_effect.h"

#include "engine/physiology/drug_kinetics.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kPropofolSleep_mgPerL = 2.6;
constexpr double kKetamineSleep_mgPerL = 0.9;
constexpr double kFentanylAnalgesia_mgPerL = 1.2e-3;
constexpr double kFentanylBreathing_mgPerL = 4.0e-3;
constexpr double kPropofolBreathing_mgPerL = 3.6;
constexpr double kRocuroniumBlock_mgPerL = 0.92;
constexpr double kSuxamethoniumBlock_mgPerL = 3.25;
constexpr double kRelaxantSteepness = 4.8;
constexpr double kDiaphragm = 1.3; ///< its concentrations over those of the larynx

double hill(double ratio, double steepness)
{
    const double power = std::pow(std::max(0.0, ratio), steepness);
    return power / (1.0 + power);
}

double at(const DrugsInBody& drugs, DrugKind kind) { return amountsOf(drugs, kind).effect_mgPerL; }

/// Of muscles that need `factor` times the concentration.
double blocked(const DrugsInBody& drugs, double factor)
{
    const double rocuronium = hill(
        at(drugs, DrugKind::Rocuronium) / (factor * kRocuroniumBlock_mgPerL), kRelaxantSteepness);
    const double suxamethonium =
        hill(at(drugs, DrugKind::Suxamethonium) / (factor * kSuxamethoniumBlock_mgPerL),
             kRelaxantSteepness);
    return 1.0 - (1.0 - rocuronium) * (1.0 - suxamethonium);
}

double drive(const DrugsInBody& drugs)
{
    const double propofol = at(drugs, DrugKind::Propofol) / kPropofolBreathing_mgPerL;
    const double fentanyl = at(drugs, DrugKind::Fentanyl) / kFentanylBreathing_mgPerL;
    return 1.0 - hill(propofol + fentanyl, 4.0);
}

double asleep(const DrugsInBody& drugs)
{
    const double opioid = hill(at(drugs, DrugKind::Fentanyl) / kFentanylAnalgesia_mgPerL, 2.0);
    const double hypnotics = at(drugs, DrugKind::Propofol) / kPropofolSleep_mgPerL
                             + at(drugs, DrugKind::Ketamine) / kKetamineSleep_mgPerL;
    return hill((1.0 + 0.3 * opioid) * hypnotics, 4.0);
}

/// Below a twentieth nobody breathes.
double orNone(double share)
{
    constexpr double kLeast = 0.05;
    return std::max(0.0, (share - kLeast) / (1.0 - kLeast));
}

} // namespace

DrugEffect effectOf(const DrugsInBody& drugs)
{
    const double propofol = hill(at(drugs, DrugKind::Propofol) / 4.0, 1.5);
    const double ketamine = hill(at(drugs, DrugKind::Ketamine) / kKetamineSleep_mgPerL, 1.5);
    const double fentanyl = hill(at(drugs, DrugKind::Fentanyl) / kFentanylAnalgesia_mgPerL, 2.0);
    const double ephedrine = hill(at(drugs, DrugKind::Ephedrine) / 0.06, 1.0);
    DrugEffect effect;
    effect.hypnosis = asleep(drugs);
    effect.analgesia = 1.0 - (1.0 - fentanyl) * (1.0 - 0.5 * ketamine);
    effect.relaxation = blocked(drugs, 1.0);
    effect.breathing = orNone(drive(drugs) * (1.0 - blocked(drugs, kDiaphragm)));
    effect.tone = (1.0 - effect.relaxation) * (1.0 - 0.6 * effect.hypnosis);
    effect.pressure = (1.0 - 0.4 * propofol) * (1.0 - 0.1 * fentanyl) * (1.0 + 0.2 * ketamine)
                      * (1.0 + 0.4 * ephedrine);
    effect.heartRate = (1.0 - 0.15 * fentanyl) * (1.0 + 0.2 * ketamine) * (1.0 + 0.3 * ephedrine);
    return effect;
}

bool isAnaesthetised(const DrugEffect& effect)
{
    return effect.hypnosis >= kAnaesthesiaFrom || effect.relaxation >= kAnaesthesiaFrom;
}

double bladeStimulus(bool inMouth) { return inMouth ? 1.0 : 0.0; }

double tubeStimulus(TubeSeat seat)
{
    switch (seat) {
    case TubeSeat::None:
        return 0.0;
    case TubeSeat::Trachea:
        return 0.8;
    case TubeSeat::RightMain:
    case TubeSeat::LeftMain:
        return 1.0;
    case TubeSeat::Oesophagus:
        return 0.4;
    }
    return 0.0;
}

double felt(double stimulus, const DrugEffect& effect)
{
    constexpr double kDepthForAll = 1.1; // of a stimulus of 1
    const double depth = effect.hypnosis + 0.5 * effect.analgesia * effect.hypnosis;
    return std::clamp(stimulus * (1.0 - depth / kDepthForAll), 0.0, 1.0);
}

bool coughsAt(double stimulus, const DrugEffect& effect)
{
    constexpr double kTooWeak = 0.75;
    return effect.relaxation < kTooWeak && felt(stimulus, effect) > kCoughsFrom;
}

double spasmAt(double stimulus, const DrugEffect& effect, TubeSeat seat)
{
    if (isThroughCords(seat)) // which holds them open
        return 0.0;
    const double sleeps = std::clamp((effect.hypnosis - 0.2) / 0.2, 0.0, 1.0);
    const double light = std::clamp(2.0 * felt(stimulus, effect), 0.0, 1.0);
    return sleeps * light * (1.0 - effect.relaxation);
}

double swallowingLeft(const DrugEffect& effect)
{
    constexpr double kBegins = 0.5; // to be lost, by hypnosis
    constexpr double kLost = 0.8;
    const double awake = std::clamp((kLost - effect.hypnosis) / (kLost - kBegins), 0.0, 1.0);
    return awake * (1.0 - effect.relaxation);
}

} // namespace carina
