#include "apps/lab/commands.h"
#include "apps/lab/rendering/scope_series.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "models/patient/patient_source.h"
#include "tests/support/test_class.h"
#include "widgets/scene/view/graphics.h"

#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QJsonObject>
#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <vector>

namespace carina::event_pairs_test
{
namespace
{

constexpr QSize kSize{320, 240};
/// A laryngoscope sees little of what these do below the cords; TestAirwayChanges holds that.
constexpr std::array<std::string_view, 3> kBelowTheCords{"tracheal_stenosis", "tracheal_deviation",
                                                         "goitre"};

/// Of the adult.
QJsonObject drawn(const QString& folder, const QStringList& more = {})
{
    const auto object =
        lab::renderCommand().run(QStringList{QStringLiteral("--event-pairs"), folder,
                                             QStringLiteral("--size"), QStringLiteral("320x240")}
                                 + more);
    if (!object)
        qWarning("%s", object.error().detail.c_str());
    return object.value_or(QJsonObject{});
}

/// What hides the glottis of a lifted larynx. The pairs can be of a step in which the glottis is
/// not seen before either.
constexpr std::array kHiding{AirwayEventKind::TongueOedema,
                             AirwayEventKind::Epiglottitis,
                             AirwayEventKind::FloppyEpiglottis,
                             AirwayEventKind::AnteriorLarynx,
                             AirwayEventKind::Vomit,
                             AirwayEventKind::ForeignBody};
constexpr double kSeenBefore = 0.5; ///< least share of the glottis
constexpr double kFall = 0.05;      ///< likewise, of what an event hides

/// The share of the adult's glottis that is seen past a lifted blade, by event at its worst; by ""
/// without one.
std::map<QString, double> openings()
{
    const auto patient =
        patientOf(patientFor(parametersOf(BuiltinPatient::Adult), Posture::Rest).value()).value();
    const auto laryngoscopy = Laryngoscopy::of(*patient, bladeOf(BladeKind::Macintosh3)).value();
    std::vector<lab::ScopeShot> shots(1);
    for (const AirwayEventKind kind : kHiding)
        shots.push_back({.events = {{kind, 1.0}}});
    std::map<QString, double> seen;
    const auto take = [&](const lab::DrawnShot& drawn) -> Result<void> {
        const AirwayEvents& events = shots[drawn.number].events;
        const char* name = events.empty() ? "" : eventName(events.front().kind);
        seen[QString::fromLatin1(name)] = drawn.seen.opening;
        return {};
    };
    const auto series = lab::drawShots(*patient, laryngoscopy, {.size = kSize}, shots, take);
    return series ? seen : std::map<QString, double>{};
}

qint64 more(const QJsonValue& pair, const char* structure)
{
    return pair[QStringLiteral("pixels_more")][QLatin1StringView{structure}].toInteger();
}

} // namespace

class TestEventPairs : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void initTestCase();
    void init();
    void drawsEveryEventAtItsWorst();
    void changesThePicture_data() { events(); }
    void changesThePicture();
    void countsWhatItChanges_data() { events(); }
    void countsWhatItChanges();
    void hidesTheGlottis_data();
    void hidesTheGlottis();
    void showsWhatLiesInTheThroat();
    void bringsAStiffNeckBack();
    void callsTeethLoose();
    void drawsOnlyWhatIsAskedFor();

private:
    static void events();
    [[nodiscard]] QJsonValue pairOf(const QString& event) const;
    [[nodiscard]] QImage picture(const QJsonValue& described) const
    {
        return QImage{m_folder.filePath(described[QStringLiteral("file")].toString())};
    }

    QTemporaryDir m_folder;
    QJsonObject m_drawn;
    std::map<QString, double> m_openings;
};

void TestEventPairs::initTestCase()
{
    if (!graphicsDriver())
        return;
    m_drawn = drawn(m_folder.path());
    m_openings = openings();
}

void TestEventPairs::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

void TestEventPairs::events()
{
    QTest::addColumn<QString>("event");
    for (const char* name : {"tongue_oedema",
                             "pharyngeal_swelling",
                             "epiglottitis",
                             "laryngeal_oedema",
                             "laryngospasm",
                             "floppy_epiglottis",
                             "anterior_larynx",
                             "angio_oedema",
                             "laryngeal_web",
                             "external_pressure",
                             "tracheal_stenosis",
                             "tracheal_deviation",
                             "goitre",
                             "neck_obesity",
                             "prominent_incisors",
                             "trismus",
                             "stiff_neck",
                             "burn",
                             "secretions",
                             "blood",
                             "vomit",
                             "foreign_body",
                             "fragile_teeth",
                             "swallowing"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

QJsonValue TestEventPairs::pairOf(const QString& event) const
{
    for (const QJsonValue pair : m_drawn[QStringLiteral("pairs")].toArray())
        if (pair[QStringLiteral("event")].toString() == event)
            return pair;
    return {};
}

void TestEventPairs::drawsEveryEventAtItsWorst()
{
    const QJsonArray pairs = m_drawn[QStringLiteral("pairs")].toArray();
    QCOMPARE(pairs.size(), 24);
    QVERIFY(m_drawn[QStringLiteral("left_out")].toArray().isEmpty());
    for (const QJsonValue pair : pairs) {
        QCOMPARE(pair[QStringLiteral("severity")].toDouble(), 1.0);
        for (const char* side : {"before", "after"})
            QCOMPARE(picture(pair[QLatin1StringView{side}]).size(), kSize);
    }
}

void TestEventPairs::changesThePicture()
{
    QFETCH(const QString, event);
    const QJsonValue pair = pairOf(event);
    const double changed = pair[QStringLiteral("changed_percent")].toDouble();
    qInfo("%s: %s, %.2f %%", qPrintable(event), qPrintable(pair[QStringLiteral("step")].toString()),
          changed);
    const bool isSame =
        picture(pair[QStringLiteral("before")]) == picture(pair[QStringLiteral("after")]);
    if (std::ranges::find(kBelowTheCords, event.toStdString()) == kBelowTheCords.end()) {
        QVERIFY(changed > 0.0);
        QVERIFY(!isSame);
    }
}

// Both count each pixel once, so what is more of some is less of others.
void TestEventPairs::countsWhatItChanges()
{
    QFETCH(const QString, event);
    const QJsonValue pair = pairOf(event);
    qint64 sum = 0;
    const QJsonObject changes = pair[QStringLiteral("pixels_more")].toObject();
    for (const QJsonValue change : changes)
        sum += change.toInteger();
    QCOMPARE(sum, qint64{0});
    const auto pixels = [&pair](const char* side, const QString& structure) {
        return pair[QLatin1StringView{side}][QStringLiteral("visible_pixels")][structure]
            .toInteger();
    };
    for (auto change = changes.begin(); change != changes.end(); ++change)
        QCOMPARE(change->toInteger(),
                 pixels("after", change.key()) - pixels("before", change.key()));
}

void TestEventPairs::hidesTheGlottis_data()
{
    QTest::addColumn<QString>("event");
    for (const AirwayEventKind kind : kHiding)
        QTest::newRow(eventName(kind)) << QString::fromLatin1(eventName(kind));
}

void TestEventPairs::hidesTheGlottis()
{
    QFETCH(const QString, event);
    QCOMPARE(m_openings.size(), kHiding.size() + 1);
    const double before = m_openings.at({});
    const double after = m_openings.at(event);
    qInfo("%s: %.0f %% of the glottis, %.0f %% before", qPrintable(event), 100.0 * after,
          100.0 * before);
    QVERIFY(before > kSeenBefore);
    QVERIFY(after < before - kFall);
}

void TestEventPairs::showsWhatLiesInTheThroat()
{
    for (const char* fluid : {"secretions", "blood", "vomit"})
        QVERIFY(more(pairOf(QString::fromLatin1(fluid)), "fluid") > 0);
    QVERIFY(more(pairOf(QStringLiteral("foreign_body")), "foreign_body") > 0);
}

// From the sniffing position, at 100 %, to the neutral one.
void TestEventPairs::bringsAStiffNeckBack()
{
    const QJsonValue pair = pairOf(QStringLiteral("stiff_neck"));
    for (const char* angle : {"neck_flexion_deg", "head_extension_deg"}) {
        QVERIFY(pair[QStringLiteral("before")][QLatin1StringView{angle}].toDouble() > 20.0);
        QVERIFY(std::abs(pair[QStringLiteral("after")][QLatin1StringView{angle}].toDouble())
                < 1e-6);
    }
}

void TestEventPairs::callsTeethLoose()
{
    const QJsonValue pair = pairOf(QStringLiteral("fragile_teeth"));
    QVERIFY(more(pair, "teeth") != 0); // one leans out of the row
    const auto teeth = [&pair](const char* side) {
        return pair[QLatin1StringView{side}][QStringLiteral("upper_teeth")].toString();
    };
    QCOMPARE(teeth("before"), QStringLiteral("firm"));
    QVERIFY(teeth("after").startsWith(QStringLiteral("loose")));
}

void TestEventPairs::drawsOnlyWhatIsAskedFor()
{
    const QTemporaryDir folder;
    const QJsonObject object =
        drawn(folder.path(), {QStringLiteral("--event"), QStringLiteral("laryngospasm=0.5"),
                              QStringLiteral("--event"), QStringLiteral("epiglottitis"),
                              QStringLiteral("--severity"), QStringLiteral("0.25")});
    const QJsonArray pairs = object[QStringLiteral("pairs")].toArray();
    QCOMPARE(pairs.size(), 2);
    QCOMPARE(pairs[0][QStringLiteral("event")].toString(), QStringLiteral("epiglottitis"));
    QCOMPARE(pairs[0][QStringLiteral("severity")].toDouble(), 0.25);
    QCOMPARE(pairs[1][QStringLiteral("severity")].toDouble(), 0.5);
    QCOMPARE(QDir{folder.path()}.entryList(QDir::Files).size(), 4);
}

CARINA_SCREEN_TEST(TestEventPairs)

} // namespace carina::event_pairs_test

#include "tst_event_pairs.moc"
