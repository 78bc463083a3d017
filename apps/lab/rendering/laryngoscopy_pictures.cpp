#include "apps/lab/rendering/laryngoscopy_pictures.h"

#include "apps/lab/rendering/quality_comparison.h"
#include "apps/lab/rendering/render_page.h"
#include "apps/lab/rendering/structural_similarity.h"
#include "engine/anatomy/airway/airway_measure.h"
#include "engine/anatomy/events/neck_motion.h"
#include "models/patient/patient_source.h"

#include <QJsonArray>

#include <vector>

namespace carina::lab
{
namespace
{

std::vector<ScopeShot> shotsOf(const LaryngoscopyOrder& order)
{
    std::vector<ScopeShot> shots;
    for (const LaryngoscopyStep step : kLaryngoscopySteps)
        shots.push_back({step, order.events, order.head, order.lift, order.levering});
    return shots;
}

/// Writes a picture, and says the name of its file.
Result<QString> saved(const LaryngoscopyOrder& order, const QImage& picture, LaryngoscopyStep step,
                      const QString& ending = {})
{
    const QString file = QStringLiteral("laryngoscopy-%1-%2-%3%4.png")
                             .arg(bladeName(order.way.blade), eyeName(order.way.eye),
                                  QString::fromLatin1(stepName(step)), ending);
    const QString path = order.folder.filePath(file);
    if (!picture.save(path))
        return fail(Errc::FileUnwritable, path.toStdString() + " cannot be written.");
    return file;
}

QJsonObject describe(const QString& file, const QString& step, const DrawnShot& drawn)
{
    return {{render_laryngoscopy_key::kFile, file},
            {render_laryngoscopy_key::kStep, step},
            {render_laryngoscopy_key::kLift, inMillimetres(drawn.pose.lift)},
            {render_laryngoscopy_key::kOpening, 100.0 * drawn.seen.opening},
            {render_laryngoscopy_key::kGrade, QString::fromLatin1(gradeName(drawn.seen.grade))},
            {render_laryngoscopy_key::kPixels, pixelsOf(drawn.seen)}};
}

void addEffort(QJsonObject& picture, const BladeEffort& effort)
{
    const std::optional<Length>& clearance = effort.contact.teethClearance;
    picture[render_laryngoscopy_key::kTongueForce] = inNewtons(effort.contact.tongue);
    picture[render_laryngoscopy_key::kEpiglottisForce] = inNewtons(effort.contact.epiglottis);
    picture[render_laryngoscopy_key::kIncisorForce] = inNewtons(effort.teeth);
    picture[render_laryngoscopy_key::kIncisorClearance] =
        clearance ? QJsonValue{inMillimetres(*clearance)} : QJsonValue{};
    picture[render_laryngoscopy_key::kLeveringShare] = 100.0 * effort.leveringShare;
    picture[render_laryngoscopy_key::kHandling] =
        QString::fromLatin1(handlingName(effort.handling));
}

QJsonArray describe(const AirwayEvents& events)
{
    QJsonArray all;
    for (const AirwayEvent& event : events)
        all.append(QJsonObject{
            {render_laryngoscopy_key::kEventName, QString::fromLatin1(eventName(event.kind))},
            {render_laryngoscopy_key::kSeverity, event.severity}});
    return all;
}

Result<QJsonArray> drawSteps(const PatientModel& patient, const Laryngoscopy& laryngoscopy,
                             const LaryngoscopyOrder& order)
{
    const std::vector<ScopeShot> shots = shotsOf(order);
    QJsonArray pictures;
    const auto take = [&](const DrawnShot& drawn) -> Result<void> {
        const ScopeShot& shot = shots[drawn.number];
        const auto file = saved(order, drawn.picture, shot.step);
        if (!file)
            return tl::unexpected(file.error());
        QJsonObject described = describe(*file, QString::fromLatin1(stepName(shot.step)), drawn);
        addEffort(described, effortOf(drawn, shot));
        pictures.append(described);
        return {};
    };
    return drawShots(patient, laryngoscopy, order.way, shots, take).map([&] { return pictures; });
}

/// How alike each quality is to the reference, once all of them are written.
Result<QJsonObject> describe(const ComparedShot& compared, LaryngoscopyStep step,
                             const LaryngoscopyOrder& order)
{
    const auto reference = saved(order, compared.reference, step, QStringLiteral("-reference"));
    if (!reference)
        return tl::unexpected(reference.error());
    QJsonObject similarities;
    for (std::size_t n = 0; n < kPictureQualities; ++n) {
        const QString quality = QString::fromLatin1(qualityName(static_cast<PictureQuality>(n)));
        const QImage& picture = compared.inQuality[n];
        if (const auto file = saved(order, picture, step, QLatin1Char{'-'} + quality); !file)
            return tl::unexpected(file.error());
        similarities[quality] = structuralSimilarity(picture, compared.reference);
    }
    return QJsonObject{{render_laryngoscopy_key::kReference, *reference},
                       {render_laryngoscopy_key::kSimilarity, similarities}};
}

/// Adds to what is said of each step how it compares.
Result<void> compareSteps(QJsonArray& pictures, const PatientModel& patient,
                          const Laryngoscopy& laryngoscopy, const LaryngoscopyOrder& order)
{
    const std::vector<ScopeShot> shots = shotsOf(order);
    const auto take = [&](const ComparedShot& compared) -> Result<void> {
        const auto described = describe(compared, shots[compared.number].step, order);
        if (!described)
            return tl::unexpected(described.error());
        QJsonObject picture = pictures[qsizetype(compared.number)].toObject();
        for (auto it = described->begin(); it != described->end(); ++it)
            picture[it.key()] = it.value();
        pictures[qsizetype(compared.number)] = picture;
        return {};
    };
    return drawCompared(patient, laryngoscopy, order.way, shots, take);
}

/// How many times in a second the last picture is drawn in each quality.
Result<QJsonObject> ratesOf(const PatientModel& patient, const Laryngoscopy& laryngoscopy,
                            const LaryngoscopyOrder& order)
{
    ScopeShot shot = shotsOf(order).back();
    QJsonObject rates;
    for (std::size_t n = 0; n < kPictureQualities; ++n) {
        shot.quality = static_cast<PictureQuality>(n);
        const auto rate = shotRate(patient, laryngoscopy, order.way, shot);
        if (!rate)
            return tl::unexpected(rate.error());
        rates[QString::fromLatin1(qualityName(shot.quality))] = *rate;
    }
    return rates;
}

} // namespace

Result<QJsonObject> drawLaryngoscopy(Anatomy anatomy, const LaryngoscopyOrder& order)
{
    if (!order.folder.mkpath(QStringLiteral(".")))
        return fail(Errc::FileUnwritable, order.folder.path().toStdString() + " cannot be made.");
    const auto patient = patientOf(std::move(anatomy));
    if (!patient)
        return tl::unexpected(patient.error());
    auto laryngoscopy = Laryngoscopy::of(**patient, bladeOf(order.way.blade));
    if (!laryngoscopy)
        return tl::unexpected(laryngoscopy.error());
    if (const auto shown = canShowAll(*laryngoscopy, order.events); !shown)
        return tl::unexpected(shown.error());
    laryngoscopy->changeAirway(order.events);
    laryngoscopy->layHead(withinMotion(order.head, order.events));
    const HeadPosition head = laryngoscopy->headPosition();
    const AirwayAxes axes = laryngoscopy->axes();
    const Length toCarina = teethToCarina(bent((*patient)->landmarks(), (*patient)->neck(head)));
    auto pictures = drawSteps(**patient, *laryngoscopy, order);
    if (!pictures)
        return tl::unexpected(pictures.error());
    if (order.isCompared)
        if (const auto compared = compareSteps(*pictures, **patient, *laryngoscopy, order);
            !compared)
            return tl::unexpected(compared.error());
    QJsonObject told{
        {render_laryngoscopy_key::kSchema,
         QLatin1StringView{render_laryngoscopy_key::kSchema.help}},
        {render_laryngoscopy_key::kAnatomy, QString::fromStdString((*patient)->name())},
        {render_laryngoscopy_key::kWidth, order.way.size.width()},
        {render_laryngoscopy_key::kHeight, order.way.size.height()},
        {render_laryngoscopy_key::kBlade, bladeName(order.way.blade)},
        {render_laryngoscopy_key::kFrom, eyeName(order.way.eye)},
        {render_laryngoscopy_key::kNeckFlexion, inDegrees(head.flexion)},
        {render_laryngoscopy_key::kHeadExtension, inDegrees(head.extension)},
        {render_laryngoscopy_key::kMouthToSight, inDegrees(axes.mouthToSight)},
        {render_laryngoscopy_key::kSightToLarynx, inDegrees(axes.sightToLarynx)},
        {render_laryngoscopy_key::kTeethToCarina, inMillimetres(toCarina)},
        {render_laryngoscopy_key::kEvents, describe(order.events)},
        {render_laryngoscopy_key::kPictures, *pictures}};
    if (!order.isCompared)
        return told;
    return ratesOf(**patient, *laryngoscopy, order).map([&told](const QJsonObject& rates) {
        told[render_laryngoscopy_key::kRates] = rates;
        return told;
    });
}

} // namespace carina::lab
