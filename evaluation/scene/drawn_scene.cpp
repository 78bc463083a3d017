#include "evaluation/scene/drawn_scene.h"

#include "engine/core/expects.h"
#include "engine/sync/strategies/view_bound.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <utility>

namespace carina
{
namespace
{

constexpr std::array kCompared{ObjectKind::Head, ObjectKind::Hand, ObjectKind::Tube};

DrawnObject objectOf(const QJsonObject& json)
{
    const QJsonArray p = json[QStringLiteral("xyz_mm")].toArray();
    const QJsonArray q = json[QStringLiteral("q_xyzw")].toArray();
    return {json[QStringLiteral("owner")].toInt(), json[QStringLiteral("kind")].toInt(),
            json[QStringLiteral("own")].toBool(),
            RigidTransform{Quat{q[3].toDouble(), q[0].toDouble(), q[1].toDouble(), q[2].toDouble()},
                           1e-3 * Vec3{p[0].toDouble(), p[1].toDouble(), p[2].toDouble()}}};
}

/// The frames between two session times.
struct Watched {
    DrawnFrames::const_iterator first;
    DrawnFrames::const_iterator last;

    [[nodiscard]] auto begin() const { return first; }
    [[nodiscard]] auto end() const { return last; }
};

Watched watched(const DrawnScene& program, double from, double until)
{
    return {program.frames.lower_bound(from), program.frames.upper_bound(until)};
}

const DrawnScene* programOf(std::span<const DrawnScene> programs, int participant)
{
    const auto found = std::ranges::find(programs, participant, &DrawnScene::participant);
    return found == programs.end() ? nullptr : &*found;
}

/// From an owner's program to a viewer's, with what the clocks of the two cannot see.
Duration delayBetween(const DrawnScene& owner, const DrawnScene& viewer,
                      const SceneConditions& conditions)
{
    const Duration unseen = std::chrono::abs(conditions.toHost - conditions.fromHost) / 2;
    return (owner.isRemote ? conditions.toHost + unseen : Duration{})
           + (viewer.isRemote ? conditions.fromHost + unseen : Duration{});
}

/// @param before the owner's view when what the viewer knows was measured; nothing if not known
Drift boundOf(const OwnersView& owners, const std::optional<OwnersView>& before, Duration delay)
{
    const double turning = std::max(owners.turning, before ? before->turning : 0.0);
    const double moving = std::max(owners.moving, before ? before->moving : 0.0);
    const double seconds = toSeconds(delay);
    const Drift seen =
        trackedViewBound({radians(turning * seconds), metres(moving * seconds)}, delay);
    const double between = owners.gap * owners.gap / 8.0;
    return {seen.rotation + between * kHandAcceleration.rotation,
            seen.position + between * kHandAcceleration.position};
}

/// The same thing of another person, and where that one's program has it.
std::vector<RigidTransform> likeThings(std::span<const DrawnScene> programs,
                                       const DrawnScene& owner, int kind, double t,
                                       double longestGap)
{
    std::vector<RigidTransform> things;
    for (const DrawnScene& other : programs) {
        if (other.participant == owner.participant || other.station != owner.station)
            continue;
        const auto frame = other.frames.lower_bound(t);
        if (frame == other.frames.end())
            continue;
        for (const auto& [id, object] : frame->second)
            if (object.isOwn && object.kind == kind)
                if (const auto view = ownersView(other.frames, id, t, longestGap))
                    things.push_back(view->X_AO);
    }
    return things;
}

void recognise(const Vec3& p_AO, const Vec3& p_AO_owner, std::span<const RigidTransform> others,
               Length bound, SceneComparison& compared)
{
    bool isRecognisable = false;
    bool isMistaken = false;
    for (const RigidTransform& other : others) {
        if ((other.translation() - p_AO_owner).norm() <= 2.0 * bound.si)
            continue;
        isRecognisable = true;
        isMistaken = isMistaken || (other.translation() - p_AO).norm() < (p_AO_owner - p_AO).norm();
    }
    compared.recognisable += isRecognisable ? 1 : 0;
    compared.mistaken += isMistaken ? 1 : 0;
}

void addDifferences(std::span<const DrawnScene> programs, const DrawnScene& viewer,
                    const Watched& frames, const SceneConditions& conditions,
                    SceneComparison& compared)
{
    for (const auto& [t, objects] : frames)
        for (const auto& [id, object] : objects) {
            const DrawnScene* owner = programOf(programs, object.owner);
            if (!owner || object.isOwn || object.kind == int(ObjectKind::Jaw))
                continue;
            const auto owners = ownersView(owner->frames, id, t, conditions.longestGap);
            if (!owners)
                continue;
            const Duration delay = delayBetween(*owner, viewer, conditions);
            const auto before = ownersView(owner->frames, id, t - toSeconds(delay + kSampleAge),
                                           conditions.longestGap);
            const Drift bound = boundOf(*owners, before, delay);
            const Drift drift = driftBetween(owners->X_AO, object.X_AO);
            auto& difference = viewer.isRemote || owner->isRemote ? compared.far : compared.near;
            difference.angles.push_back(drift.rotation.si);
            difference.distances.push_back(drift.position.si);
            if (drift.rotation > bound.rotation || drift.position > bound.position)
                ++difference.beyond;
            recognise(object.X_AO.translation(), owners->X_AO.translation(),
                      likeThings(programs, *owner, object.kind, t, conditions.longestGap),
                      bound.position, compared);
        }
}

/// Of an object in all programs, by object.
using Known = std::map<int, std::pair<int, int>>;

void addOwners(const Watched& frames, Known& known, SceneComparison& compared)
{
    for (const auto& [t, objects] : frames)
        for (const auto& [id, object] : objects) {
            const std::pair now{object.owner, object.kind};
            auto& before = known.try_emplace(id, now).first->second;
            if (std::exchange(before, now) != now)
                ++compared.ownerChanges;
        }
}

/// The number of a program's own object of a kind; nothing where it never had one.
std::optional<int> ownObject(const DrawnScene& program, ObjectKind kind)
{
    for (const auto& [t, objects] : program.frames)
        for (const auto& [id, object] : objects)
            if (object.isOwn && object.kind == int(kind))
                return id;
    return std::nullopt;
}

/// Of a viewer's frames at whose time the owner's program had the object: the share that drew it.
double shareDrawn(const Watched& frames, const DrawnScene& owner, ObjectKind kind,
                  double longestGap)
{
    const auto id = ownObject(owner, kind);
    int wanted = 0;
    int drawn = 0;
    for (const auto& [t, objects] : frames) {
        if (!id || !ownersView(owner.frames, *id, t, longestGap))
            continue;
        ++wanted;
        drawn += std::ranges::any_of(objects, [&](const auto& entry) {
            const DrawnObject& object = entry.second;
            return !object.isOwn && object.owner == owner.participant && object.kind == int(kind);
        });
    }
    return wanted > 0 ? double(drawn) / double(wanted) : 0.0;
}

void addShares(std::span<const DrawnScene> programs, const DrawnScene& viewer,
               const Watched& frames, double longestGap, SceneComparison& compared)
{
    for (const DrawnScene& other : programs) {
        const bool isHere = other.station == viewer.station;
        if (!other.hasTools || !isHere || other.participant == viewer.participant)
            continue;
        for (const ObjectKind kind : kCompared) {
            const double share = shareDrawn(frames, other, kind, longestGap);
            if (compared.pairs == 0 || share < compared.leastShare) {
                compared.leastShare = share;
                compared.leastDrawn = {viewer.participant, other.participant, kind};
            }
            ++compared.pairs;
        }
    }
}

} // namespace

DrawnFrames drawnFramesIn(const QString& journal)
{
    DrawnFrames frames;
    QFile file{journal};
    if (!file.open(QIODevice::ReadOnly))
        return frames;
    for (const QByteArray& line : file.readAll().split('\n'))
        for (const QJsonValue& frame :
             QJsonDocument::fromJson(line).object()[QStringLiteral("frames")].toArray()) {
            auto& objects = frames[1e-9 * double(frame[QStringLiteral("session_ns")].toInteger())];
            for (const QJsonValue& object : frame[QStringLiteral("objects")].toArray())
                objects[object[QStringLiteral("object")].toInt()] = objectOf(object.toObject());
        }
    return frames;
}

std::optional<OwnersView> ownersView(const DrawnFrames& owners, int object, double t,
                                     double longestGap)
{
    const auto after = owners.lower_bound(t);
    if (after == owners.end() || after == owners.begin())
        return std::nullopt;
    const auto before = std::prev(after);
    const double gap = after->first - before->first;
    const auto a = before->second.find(object);
    const auto b = after->second.find(object);
    if (a == before->second.end() || b == after->second.end() || !a->second.isOwn
        || !b->second.isOwn || gap > longestGap)
        return std::nullopt;
    const double share = (t - before->first) / gap;
    const Vec3& p = a->second.X_AO.translation();
    const Drift moved = driftBetween(a->second.X_AO, b->second.X_AO);
    return OwnersView{.X_AO = {a->second.X_AO.rotation().slerp(share, b->second.X_AO.rotation()),
                               p + share * (b->second.X_AO.translation() - p)},
                      .turning = moved.rotation.si / gap,
                      .moving = moved.position.si / gap,
                      .gap = gap};
}

SceneComparison compareScenes(std::span<const DrawnScene> programs, double from, double until,
                              const SceneConditions& conditions)
{
    SceneComparison compared;
    Known known;
    for (const DrawnScene& viewer : programs) {
        const Watched frames = watched(viewer, from, until);
        addDifferences(programs, viewer, frames, conditions, compared);
        addOwners(frames, known, compared);
        addShares(programs, viewer, frames, conditions.longestGap, compared);
    }
    return compared;
}

bool isWithin(const SceneDifference& difference, const SceneBounds& bounds)
{
    if (difference.distances.empty())
        return false;
    const auto isBelow = [&difference](double share, const Drift& bound) {
        return quantileOf(difference.distances, share) <= bound.position.si
               && quantileOf(difference.angles, share) <= bound.rotation.si;
    };
    return isBelow(0.5, bounds.median) && isBelow(0.95, bounds.p95);
}

double quantileOf(std::vector<double> values, double share)
{
    CARINA_EXPECTS(!values.empty());
    const auto rank =
        std::min(values.size() - 1, std::size_t(share * static_cast<double>(values.size())));
    std::ranges::nth_element(values, values.begin() + std::ptrdiff_t(rank));
    return values[rank];
}

} // namespace carina
