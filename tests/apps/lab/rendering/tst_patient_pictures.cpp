#include "apps/lab/commands.h"
#include "tests/support/test_class.h"
#include "widgets/scene/view/graphics.h"

#include <QImage>
#include <QJsonArray>
#include <QTemporaryDir>

#include <cmath>

namespace carina::patient_pictures_test
{

namespace
{

constexpr QSize kSize{320, 200};
constexpr double kRestingBreath_ml = 280.0; ///< 7 ml/kg of the child's 40 kg
constexpr double kBreathTolerance_ml = 15.0;
constexpr int kPerCondition = 6;
/// Of a lung beside gas of 0.9 of the way to the room's pressure, where 1 leaves a quarter.
constexpr double kCollapsedShare = 1.0 - 0.75 * 0.9;
constexpr double kShareTolerance = 0.05;

double total_ml(const QJsonValue& picture)
{
    const QJsonValue volume_ml = picture[QStringLiteral("volume_ml")];
    return volume_ml[QStringLiteral("right")].toDouble()
           + volume_ml[QStringLiteral("left")].toDouble();
}

} // namespace

class TestPatientPictures : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void initTestCase();
    void init();
    void drawsBothEndsOfABreathFromThreeSides();
    void drawsTheVolumesOfARestingBreath();
    void drawsACollapsedLungOnItsSide();
    void drawsTheBreathsOfAVentilator();
    void opensTheMouthAndLeavesTheLungs();

private:
    [[nodiscard]] QImage picture(int i) const;
    [[nodiscard]] double figure(int i, const char* name, const char* side) const;

    QTemporaryDir m_folder;
    QJsonArray m_pictures; ///< of health, pneumothorax and COPD
};

QImage TestPatientPictures::picture(int i) const
{
    return QImage{m_folder.filePath(QStringLiteral("new/")
                                    + m_pictures[i][QStringLiteral("file")].toString())};
}

double TestPatientPictures::figure(int i, const char* name, const char* side) const
{
    return m_pictures[i][QLatin1StringView{name}][QLatin1StringView{side}].toDouble();
}

void TestPatientPictures::initTestCase()
{
    if (!graphicsDriver())
        return;
    const auto object = lab::renderCommand().run(
        {QStringLiteral("--pictures"), m_folder.filePath(QStringLiteral("new")),
         QStringLiteral("--size"), QStringLiteral("320x200")});
    QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
    m_pictures = object.value()[QStringLiteral("pictures")].toArray();
    QCOMPARE(m_pictures.size(), 3 * kPerCondition);
}

void TestPatientPictures::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

void TestPatientPictures::drawsBothEndsOfABreathFromThreeSides()
{
    QStringList shown;
    QList<QImage> different;
    for (int i = 0; i < m_pictures.size(); ++i) {
        if (i < kPerCondition)
            shown += m_pictures[i][QStringLiteral("view")].toString() + QLatin1Char{' '}
                     + m_pictures[i][QStringLiteral("phase")].toString();
        QCOMPARE(picture(i).size(), kSize);
        QVERIFY(!different.contains(picture(i)));
        different += picture(i);
    }
    QCOMPARE(shown,
             (QStringList{QStringLiteral("front expired"), QStringLiteral("side expired"),
                          QStringLiteral("trainee expired"), QStringLiteral("front inspired"),
                          QStringLiteral("side inspired"), QStringLiteral("trainee inspired")}));
}

void TestPatientPictures::drawsTheVolumesOfARestingBreath()
{
    QCOMPARE(total_ml(m_pictures[2]), total_ml(m_pictures[0]));
    const double breath_ml = total_ml(m_pictures[3]) - total_ml(m_pictures[0]);
    QVERIFY(std::abs(breath_ml - kRestingBreath_ml) < kBreathTolerance_ml);
    for (const char* side : {"right", "left"}) {
        const double dome_mm =
            figure(3, "dome_descent_mm", side) - figure(0, "dome_descent_mm", side);
        QVERIFY(dome_mm > 0.0);
        QVERIFY(figure(0, "diaphragm_excursion_mm", side) >= dome_mm);
    }
}

void TestPatientPictures::drawsACollapsedLungOnItsSide()
{
    const QJsonValue ill = m_pictures[kPerCondition];
    QCOMPARE(ill[QStringLiteral("condition")].toString(), QStringLiteral("simple_pneumothorax"));
    QCOMPARE(ill[QStringLiteral("side")].toString(), QStringLiteral("right"));
    const auto share = [this](const char* side) {
        return figure(kPerCondition, "volume_ml", side) / figure(0, "volume_ml", side);
    };
    QVERIFY2(std::abs(share("right") - kCollapsedShare) < kShareTolerance,
             qPrintable(QString::number(share("right"))));
    QVERIFY(share("left") > 0.8);
}

// Volume control gives what is set; of their own these patients breathe 0.64 of it.
void TestPatientPictures::drawsTheBreathsOfAVentilator()
{
    const auto object = lab::renderCommand().run(
        QStringLiteral("--condition copd --severity 0.9 --ventilator volume --size 320x200")
            .split(QLatin1Char{' '})
        + QStringList{QStringLiteral("--pictures"), m_folder.path()});
    QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
    const QJsonArray pictures = object.value()[QStringLiteral("pictures")].toArray();
    QCOMPARE(pictures.size(), kPerCondition);
    QCOMPARE(pictures[0][QStringLiteral("ventilator")], QStringLiteral("volume"));
    QVERIFY(pictures[0][QStringLiteral("file")].toString().contains(
        QStringLiteral("ventilator-volume")));
    const double breath_ml = total_ml(pictures[3]) - total_ml(pictures[0]);
    QVERIFY(std::abs(breath_ml - kRestingBreath_ml) < kBreathTolerance_ml);
}

void TestPatientPictures::opensTheMouthAndLeavesTheLungs()
{
    const QString folder = m_folder.filePath(QStringLiteral("open"));
    const auto object = lab::renderCommand().run(
        {QStringLiteral("--pictures"), folder, QStringLiteral("--size"), QStringLiteral("320x200"),
         QStringLiteral("--condition"), QStringLiteral("normal"), QStringLiteral("--jaw-deg"),
         QStringLiteral("20"), QStringLiteral("--jaw-forward-mm"), QStringLiteral("5")});
    QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
    QCOMPARE(object.value()[QStringLiteral("jaw_deg")].toDouble(), 20.0);
    QCOMPARE(object.value()[QStringLiteral("jaw_forward_mm")].toDouble(), 5.0);
    const QJsonArray open = object.value()[QStringLiteral("pictures")].toArray();
    QCOMPARE(open.size(), kPerCondition);
    for (int i = 0; i < kPerCondition; ++i) {
        const QString file = open[i][QStringLiteral("file")].toString();
        QCOMPARE(open[i][QStringLiteral("volume_ml")], m_pictures[i][QStringLiteral("volume_ml")]);
        QVERIFY(QImage{folder + QLatin1Char{'/'} + file} != picture(i));
    }
}

CARINA_SCREEN_TEST(TestPatientPictures)

} // namespace carina::patient_pictures_test

#include "tst_patient_pictures.moc"
