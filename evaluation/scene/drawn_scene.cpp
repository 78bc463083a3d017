#include "evaluation/scene/drawn_scene.h"

#include "engine/core/expects.h"
#include "engine/geometry/rotation.h"

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

void addDifferences(std::span<const DrawnScene> programs, const DrawnScene& viewer,
                    const Watched& frames, double longestGap, SceneComparison& compared)
{
    for (const auto& [t, objects] : frames)
        for (const auto& [id, object] : objects) {
            const DrawnScene* owner = programOf(programs, object.owner);
            if (!owner || object.isOwn || object.kind == int(ObjectKind::Jaw))
                continue;
            const auto owners = ownersPose(owner->frames, id, t, longestGap);
            if (!owners)
                continue;
            auto& difference = viewer.isRemote || owner->isRemote ? compared.far : compared.near;
            difference.angles.push_back(
                angleBetween(object.X_AO.rotation(), owners->rotation()).si);
            difference.distances.push_back(
                (object.X_AO.translation() - owners->translation()).norm());
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

void addShares(std::span<const DrawnScene> programs, const DrawnScene& viewer,
               const Watched& frames, SceneComparison& compared)
{
    std::map<std::pair<int, int>, int> drawn; // by owner and kind
    for (const auto& [t, objects] : frames)
        for (const auto& [id, object] : objects)
            if (!object.isOwn)
                ++drawn[{object.owner, object.kind}];
    const auto count = std::distance(frames.begin(), frames.end());
    for (const DrawnScene& other : programs) {
        const bool isHere = other.station == viewer.station;
        if (!other.hasTools || !isHere || other.participant == viewer.participant)
            continue;
        for (const ObjectKind kind : kCompared) {
            const int times = drawn[{other.participant, int(kind)}];
            const double share = count > 0 ? double(times) / double(count) : 0.0;
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

std::optional<RigidTransform> ownersPose(const DrawnFrames& owners, int object, double t,
                                         double longestGap)
{
    const auto after = owners.lower_bound(t);
    if (after == owners.end() || after == owners.begin())
        return std::nullopt;
    const auto before = std::prev(after);
    const auto a = before->second.find(object);
    const auto b = after->second.find(object);
    if (a == before->second.end() || b == after->second.end() || !a->second.isOwn
        || !b->second.isOwn || after->first - before->first > longestGap)
        return std::nullopt;
    const double share = (t - before->first) / (after->first - before->first);
    const Vec3& p = a->second.X_AO.translation();
    return RigidTransform{a->second.X_AO.rotation().slerp(share, b->second.X_AO.rotation()),
                          p + share * (b->second.X_AO.translation() - p)};
}

SceneComparison compareScenes(std::span<const DrawnScene> programs, double from, double until,
                              double longestGap)
{
    SceneComparison compared;
    Known known;
    for (const DrawnScene& viewer : programs) {
        const Watched frames = watched(viewer, from, until);
        addDifferences(programs, viewer, frames, longestGap, compared);
        addOwners(frames, known, compared);
        addShares(programs, viewer, frames, compared);
    }
    return compared;
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
