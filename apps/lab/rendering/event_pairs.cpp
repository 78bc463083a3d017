#include "apps/lab/rendering/event_pairs.h"

#include "apps/lab/rendering/render_page.h"
#include "models/patient/patient_source.h"
#include "models/station/laryngoscope_sight.h"

#include <QJsonArray>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

namespace carina::lab
{
namespace
{

constexpr int kOtherColor = 6; ///< of 255, by which a channel of a pixel has changed

/// The share of the pixels that are of another colour.
double changedShare(const QImage& before, const QImage& after)
{
    const QImage a = before.convertToFormat(QImage::Format_RGB32);
    const QImage b = after.convertToFormat(QImage::Format_RGB32);
    const auto differ = [](QRgb p, QRgb q) {
        return std::abs(qRed(p) - qRed(q)) > kOtherColor
               || std::abs(qGreen(p) - qGreen(q)) > kOtherColor
               || std::abs(qBlue(p) - qBlue(q)) > kOtherColor;
    };
    qint64 changed = 0;
    for (int y = 0; y < a.height(); ++y) {
        const auto* p = reinterpret_cast<const QRgb*>(a.constScanLine(y));
        const auto* q = reinterpret_cast<const QRgb*>(b.constScanLine(y));
        for (int x = 0; x < a.width(); ++x)
            changed += differ(p[x], q[x]) ? 1 : 0;
    }
    return double(changed) / std::max(1.0, double(a.width()) * a.height());
}

/// What of a picture is kept.
struct KeptPicture {
    QImage picture{};
    GlotticView seen{};
    HeadPosition head{};
    UpperTeeth teeth = UpperTeeth::Firm;
};

KeptPicture kept(const DrawnShot& drawn, const ScopeShot& shot)
{
    return {.picture = drawn.picture.copy(),
            .seen = drawn.seen,
            .head = drawn.laryngoscopy.headPosition(),
            .teeth = upperTeeth(effortOf(drawn, shot).contact,
                                severityOf(shot.events, AirwayEventKind::FragileTeeth),
                                UpperTeeth::Firm)};
}

const char* teethName(UpperTeeth teeth)
{
    switch (teeth) {
    case UpperTeeth::Firm:
        return "firm";
    case UpperTeeth::Loose:
        return "loose";
    case UpperTeeth::LooseAndNear:
        return "loose_and_near";
    }
    return "";
}

/// A stiff neck is seen only of a head that is to lie otherwise than in neutral position.
HeadPosition headFor(AirwayEventKind kind)
{
    return kind == AirwayEventKind::StiffNeck ? kSniffing : HeadPosition{};
}

bool isOfHead(const ScopeShot& shot, const HeadPosition& head)
{
    return shot.events.empty() && shot.head == head;
}

/// First those without an event, with the head as each of the events needs it.
std::vector<ScopeShot> pairShots(const AirwayEvents& events)
{
    std::vector<ScopeShot> shots;
    const auto addSteps = [&shots](const AirwayEvents& one, const HeadPosition& head) {
        for (const LaryngoscopyStep step : kLaryngoscopySteps)
            shots.push_back({.step = step, .events = one, .head = head});
    };
    for (const AirwayEvent& event : events) {
        const HeadPosition head = headFor(event.kind);
        if (std::ranges::none_of(shots,
                                 [&head](const ScopeShot& shot) { return isOfHead(shot, head); }))
            addSteps({}, head);
    }
    for (const AirwayEvent& event : events)
        addSteps({event}, headFor(event.kind));
    return shots;
}

QJsonObject describe(const QString& file, const KeptPicture& picture)
{
    return {{render_pairs_key::kFile, file},
            {render_pairs_key::kOpening, 100.0 * picture.seen.opening},
            {render_pairs_key::kGrade, QString::fromLatin1(gradeName(picture.seen.grade))},
            {render_pairs_key::kNeckFlexion, inDegrees(picture.head.flexion)},
            {render_pairs_key::kHeadExtension, inDegrees(picture.head.extension)},
            {render_pairs_key::kTeeth, QString::fromLatin1(teethName(picture.teeth))},
            {render_pairs_key::kPixels, pixelsOf(picture.seen)}};
}

QJsonObject pixelsMore(const GlotticView& before, const GlotticView& after)
{
    QJsonObject more;
    for (std::size_t n = 0; n < kSeenStructures; ++n)
        if (const qint64 change = qint64(after.visiblePixels[n]) - qint64(before.visiblePixels[n]);
            change != 0)
            more[QString::fromLatin1(structureName(static_cast<SeenStructure>(n)))] = change;
    return more;
}

/// Holds each picture of an event against the one without it, and writes those of one step.
class PairsOfPictures
{
public:
    PairsOfPictures(const std::vector<ScopeShot>& shots, const QDir& folder)
        : m_shots{shots}, m_folder{folder}
    {
    }

    Result<void> take(const DrawnShot& drawn)
    {
        const ScopeShot& shot = m_shots[drawn.number];
        if (shot.events.empty()) {
            m_before.emplace(drawn.number, kept(drawn, shot));
            return {};
        }
        const KeptPicture& before = beforeOf(shot);
        const double changed = changedShare(before.picture, drawn.picture);
        if (shot.step == kLaryngoscopySteps.front() || changed >= m_changed) {
            m_changed = changed;
            m_best = &before;
            m_step = shot.step;
            m_after = kept(drawn, shot);
        }
        return shot.step == kLaryngoscopySteps.back() ? write(shot.events.front()) : Result<void>{};
    }

    [[nodiscard]] const QJsonArray& pairs() const { return m_pairs; }

private:
    [[nodiscard]] const KeptPicture& beforeOf(const ScopeShot& shot) const
    {
        const auto found = std::ranges::find_if(m_before, [&](const auto& one) {
            const ScopeShot& other = m_shots[one.first];
            return other.step == shot.step && other.head == shot.head;
        });
        return found->second;
    }

    Result<void> write(const AirwayEvent& event)
    {
        const QString name = QString::fromLatin1(eventName(event.kind));
        const QString before = QStringLiteral("event-%1-before.png").arg(name);
        const QString after = QStringLiteral("event-%1-after.png").arg(name);
        for (const auto& [file, picture] : {std::pair{&before, &m_best->picture},
                                            std::pair{&after, &std::as_const(m_after).picture}})
            if (const QString path = m_folder.filePath(*file); !picture->save(path))
                return fail(Errc::FileUnwritable, path.toStdString() + " cannot be written.");
        m_pairs.append(
            QJsonObject{{render_pairs_key::kEvent, name},
                        {render_pairs_key::kSeverity, event.severity},
                        {render_pairs_key::kStep, QString::fromLatin1(stepName(m_step))},
                        {render_pairs_key::kChanged, 100.0 * m_changed},
                        {render_pairs_key::kPixelsMore, pixelsMore(m_best->seen, m_after.seen)},
                        {render_pairs_key::kBefore, describe(before, *m_best)},
                        {render_pairs_key::kAfter, describe(after, m_after)}});
        return {};
    }

    const std::vector<ScopeShot>& m_shots;
    const QDir& m_folder;
    std::map<std::size_t, KeptPicture> m_before; ///< by the number of the shot
    const KeptPicture* m_best = nullptr;         ///< before, of the step that changes most so far
    KeptPicture m_after;                         ///< the same step
    LaryngoscopyStep m_step = LaryngoscopyStep::Full;
    double m_changed = 0.0;
    QJsonArray m_pairs;
};

/// Takes away what the patient cannot show, and names it.
QJsonArray leaveOut(AirwayEvents& events, const Laryngoscopy& laryngoscopy)
{
    QJsonArray names;
    std::erase_if(events, [&](const AirwayEvent& event) {
        if (laryngoscopy.canShow(event.kind))
            return false;
        names.append(QString::fromLatin1(eventName(event.kind)));
        return true;
    });
    return names;
}

} // namespace

Result<QJsonObject> drawEventPairs(Anatomy anatomy, const PairOrder& order)
{
    if (!order.folder.mkpath(QStringLiteral(".")))
        return fail(Errc::FileUnwritable, order.folder.path().toStdString() + " cannot be made.");
    const auto patient = patientOf(std::move(anatomy));
    if (!patient)
        return tl::unexpected(patient.error());
    const auto laryngoscopy = Laryngoscopy::of(**patient, bladeOf(order.way.blade));
    if (!laryngoscopy)
        return tl::unexpected(laryngoscopy.error());
    AirwayEvents events = order.events;
    const QJsonArray leftOut = order.leavesOut ? leaveOut(events, *laryngoscopy) : QJsonArray{};
    if (const auto shown = canShowAll(*laryngoscopy, events); !shown)
        return tl::unexpected(shown.error());
    const std::vector<ScopeShot> shots = pairShots(events);
    PairsOfPictures pairs{shots, order.folder};
    const auto take = [&pairs](const DrawnShot& drawn) { return pairs.take(drawn); };
    return drawShots(**patient, *laryngoscopy, order.way, shots, take).map([&] {
        return QJsonObject{
            {render_pairs_key::kSchema, QLatin1StringView{render_pairs_key::kSchema.help}},
            {render_pairs_key::kAnatomy, QString::fromStdString((*patient)->name())},
            {render_pairs_key::kBlade, bladeName(order.way.blade)},
            {render_pairs_key::kFrom, eyeName(order.way.eye)},
            {render_pairs_key::kWidth, order.way.size.width()},
            {render_pairs_key::kHeight, order.way.size.height()},
            {render_pairs_key::kLeftOut, leftOut},
            {render_pairs_key::kPairs, pairs.pairs()}};
    });
}

} // namespace carina::lab
