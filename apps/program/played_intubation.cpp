#include "apps/program/played_intubation.h"

#include "apps/program/listening_round.h"
#include "engine/airway/tube/tube_size.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/io/anatomy_set/anatomy_cache.h"
#include "engine/tracking/simulated/scripted_hands.h"
#include "evaluation/intubation/motion_script.h"
#include "models/patient/resting_patient.h"
#include "models/vitals/stethoscope.h"

#include <QStringList>

#include <algorithm>
#include <memory>
#include <utility>

namespace carina::program
{
namespace
{

const QString kIntubation = QStringLiteral("intubation");
const QString kSeed = QStringLiteral("seed");
const QString kAfter = QStringLiteral("after");

/// After the cuff is inflated, when the first breath has been given.
constexpr Duration kToListen = std::chrono::seconds{4};

Result<MotionKind> motionNamed(const QString& name)
{
    if (const auto kind = motionFromName(name.toStdString()))
        return *kind;
    return fail(Errc::WrongOption,
                "\"" + name.toStdString() + "\" is not among the intubations " + namesOfMotions());
}

Result<void> wrongNumber(const QString& word, const char* range)
{
    return fail(
        Errc::WrongOption,
        QStringLiteral("\"%1\" is not a number %2").arg(word, QLatin1String{range}).toStdString());
}

/// One word, if it is about an intubation.
Result<void> take(const QString& name, const QString& value, PlayedIntubation& played)
{
    bool isNumber = false;
    if (name == kIntubation)
        return motionNamed(value).map([&](MotionKind kind) { played.kind = kind; });
    if (name == kSeed) {
        played.seed = value.toUInt(&isNumber);
        return isNumber ? Result<void>{}
                        : wrongNumber(name + QLatin1Char{'='} + value, "from 0 on");
    }
    const double seconds = value.toDouble(&isNumber);
    if (!isNumber || !(seconds >= 0.0 && seconds <= toSeconds(kLongestWait)))
        return wrongNumber(name + QLatin1Char{'='} + value, "from 0 to 600");
    played.after = fromSeconds(seconds);
    return {};
}

/// What the ways of a tube's tip are found by.
Anatomy anatomyOf(const PatientModel& patient)
{
    Anatomy anatomy;
    anatomy.name = patient.name();
    anatomy.contentHash = patient.contentHash();
    anatomy.landmarks = patient.landmarks();
    for (const PatientSurface& surface : patient.surfaces())
        if (surface.body != SurfaceBody::Tube) {
            anatomy.parts.push_back(surface.description);
            anatomy.parts.back().levels.push_back(*surface.levels.front());
        }
    return anatomy;
}

HandledTools handledIn(const IntubationMotion& motion, Duration t)
{
    const MotionMoment moment = motion.at(t);
    const AirwayLandmarks& airway = motion.patient().airway;
    const NeckField neck{airway.p_A_glottis, airway.p_A_incisors, moment.head};
    const RigidTransform X_UA = neck.X_AU().inverse();
    return {.X_UE = X_UA * moment.X_AE, .X_UL = X_UA * moment.X_AL, .X_UJ = moment.X_AJ};
}

std::optional<FactBody> saidBy(MotionAct act)
{
    switch (act) {
    case MotionAct::CuffInflated:
        return fact::CuffSet{true};
    case MotionAct::CuffDeflated:
        return fact::CuffSet{false};
    case MotionAct::StyletOut:
        return fact::StyletDrawn{};
    case MotionAct::BreathsBegin:
    case MotionAct::BreathsEnd:
        break; // by who holds the bag
    }
    return std::nullopt;
}

Result<IntubationMotion> motionFor(const PatientModel& patient, const PlayedIntubation& played)
{
    auto ways = motionPatient(anatomyOf(patient), heldJaw(patient.contentHash()));
    if (!ways)
        return tl::unexpected(ways.error());
    if (const auto script = scriptAtRest(patient, AnatomyCache::defaultFolder()))
        ways->forBlade = {script->airway, script->throat, script->held};
    const auto size = tubeOfSize(patient.tube().innerDiameter);
    if (!size)
        return tl::unexpected(size.error());
    std::mt19937 random = generatorOf(played.kind, played.seed);
    const MotionParameters parameters = drawnParameters(played.kind, random);
    return scriptedMotion(
        played.kind, parameters, std::make_shared<const MotionPatient>(*std::move(ways)),
        lengthened(patient.tube(), size->length), static_cast<std::uint32_t>(random()));
}

/// Once the cuff is inflated, until it is emptied: who intubated listens whether the chest is
/// ventilated.
ListeningRound listeningIn(const IntubationMotion& motion, const PatientModel& patient)
{
    ListeningRound round{stylusBesideCheek(patient.landmarks().p_A_incisors),
                         ChestSites{patient}.placesToListen()};
    std::optional<Duration> inflated;
    for (const MotionCommand& command : motion.commands()) {
        if (command.act == MotionAct::CuffInflated)
            inflated = command.at;
        if (command.act == MotionAct::CuffDeflated && inflated)
            round.listen(*std::exchange(inflated, std::nullopt) + kToListen, command.at);
    }
    if (inflated)
        round.listen(*inflated + kToListen);
    return round;
}

PlayedMotion playedBy(const IntubationMotion& motion, const PatientModel& patient, Duration after)
{
    PlayedMotion played;
    played.laryngoscope = "laryngoscope " + std::string{motion.blade().name};
    for (const MotionCommand& command : motion.commands())
        if (const auto said = saidBy(command.act))
            played.controls.push_back({after + command.at, *said});
    played.at = [kept = std::make_shared<const IntubationMotion>(motion),
                 round = listeningIn(motion, patient), after](Duration t) {
        HandledTools held = handledIn(*kept, std::clamp(t - after, Duration{}, kept->length()));
        held.X_AS = round.at(t - after);
        return held;
    };
    return played;
}

} // namespace

Result<SimulatedWords> simulatedWordsIn(const QString& words)
{
    PlayedIntubation played;
    QStringList others;
    bool isPlayed = false;
    QString without; ///< a word that says something of an intubation
    for (const QString& word : words.split(QLatin1Char{','})) {
        const QString name = word.section(QLatin1Char{'='}, 0, 0);
        if (name != kIntubation && name != kSeed && name != kAfter) {
            others += word;
            continue;
        }
        if (const auto taken = take(name, word.section(QLatin1Char{'='}, 1), played); !taken)
            return tl::unexpected(taken.error());
        isPlayed = isPlayed || name == kIntubation;
        without = word;
    }
    if (!isPlayed && !without.isEmpty())
        return fail(Errc::WrongOption, "simulated: \"" + without.toStdString()
                                           + "\" needs intubation=SCRIPT beside it");
    return SimulatedWords{isPlayed ? std::optional{played} : std::nullopt,
                          others.join(QLatin1Char{','})};
}

QString motionNames() { return QString::fromStdString(namesOfMotions()); }

MotionParameters parametersOf(const PlayedIntubation& played)
{
    std::mt19937 random = generatorOf(played.kind, played.seed);
    return drawnParameters(played.kind, random);
}

PlayMotion playOf(const PlayedIntubation& played)
{
    return [played](const PatientModel& patient) {
        return motionFor(patient, played).map([&](const IntubationMotion& motion) {
            return playedBy(motion, patient, played.after);
        });
    };
}

} // namespace carina::program
