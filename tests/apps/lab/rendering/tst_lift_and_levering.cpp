#include "tests/apps/lab/rendering/drawn_laryngoscopy.h"
#include "tests/support/test_class.h"
#include "widgets/scene/view/graphics.h"

#include <QTemporaryDir>

#include <optional>

namespace carina::lift_and_levering_test
{

using namespace drawn_laryngoscopy;

/// What is seen by who does not lift, and by who levers instead.
class TestLiftAndLevering : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init();
    void seesNoMoreThanTheEpiglottisWithoutALift_data();
    void seesNoMoreThanTheEpiglottisWithoutALift();
    void pressesTheTeethByLeveringBeforeGrade2();

private:
    /// The last picture of a laryngoscopy, in which it is lifted or levered most.
    [[nodiscard]] QJsonValue lastOf(const QStringList& more) const;

    QTemporaryDir m_folder;
};

void TestLiftAndLevering::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

QJsonValue TestLiftAndLevering::lastOf(const QStringList& more) const
{
    const QJsonArray pictures = drawn(m_folder.path(), more)[QStringLiteral("pictures")].toArray();
    return pictures.size() == 5 ? pictures.last() : QJsonValue{};
}

void TestLiftAndLevering::seesNoMoreThanTheEpiglottisWithoutALift_data()
{
    QTest::addColumn<QString>("patient");
    QTest::addColumn<QString>("blade");
    const auto row = [](const char* patient, const char* blade) {
        QTest::newRow(patient) << QString::fromLatin1(patient) << QString::fromLatin1(blade);
    };
    row("adult", "macintosh-3");
    row("6 years, 116 cm, boy", "macintosh-2");
    row("1 year, 75 cm, girl", "miller-1");
    row("newborn, 50 cm, girl", "miller-0");
}

void TestLiftAndLevering::seesNoMoreThanTheEpiglottisWithoutALift()
{
    QFETCH(const QString, patient);
    QFETCH(const QString, blade);
    const QJsonValue last =
        lastOf({QStringLiteral("--lift-mm"), QStringLiteral("0"), QStringLiteral("--patient"),
                patient, QStringLiteral("--blade"), blade});
    QVERIFY2(grade(last) == QStringLiteral("3") || grade(last) == QStringLiteral("4"),
             qPrintable(grade(last)));
}

/// Of the adult with a macintosh-3 that is not lifted, at the first angle each in steps of 5
/// degrees.
void TestLiftAndLevering::pressesTheTeethByLeveringBeforeGrade2()
{
    std::optional<int> onTeeth_deg;
    std::optional<int> grade2_deg;
    for (int angle_deg = 0; angle_deg <= 20; angle_deg += 5) {
        const QJsonValue last =
            lastOf({QStringLiteral("--blade"), QStringLiteral("macintosh-3"),
                    QStringLiteral("--levering-deg"), QString::number(angle_deg)});
        const double force_N = last[QStringLiteral("incisor_force_N")].toDouble();
        qInfo("%d degrees: %.1f N on the teeth, grade %s", angle_deg, force_N,
              qPrintable(grade(last)));
        QVERIFY(!grade(last).isEmpty());
        if (!onTeeth_deg && force_N > 0.0)
            onTeeth_deg = angle_deg;
        if (!grade2_deg && grade(last) < QStringLiteral("3"))
            grade2_deg = angle_deg;
    }
    QVERIFY(onTeeth_deg && grade2_deg);
    QVERIFY(*onTeeth_deg > 0); // not by the way in
    QVERIFY(*onTeeth_deg < *grade2_deg);
}

CARINA_SCREEN_TEST(TestLiftAndLevering)

} // namespace carina::lift_and_levering_test

#include "tst_lift_and_levering.moc"
