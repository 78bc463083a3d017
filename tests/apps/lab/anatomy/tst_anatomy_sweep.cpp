#include "apps/lab/commands.h"
#include "tests/support/test_class.h"

#include <QJsonArray>

namespace carina::lab::anatomy_sweep_test
{

constexpr int kLimits =
    144; ///< combinations at the limits of what moves, as docs/deformation.md has

class TestAnatomySweep final : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// At the limits of jaw, neck, blades and events, in the finest surfaces. Nothing is inverted
    /// but the skin of a bent neck, as docs/deformation.md says.
    void noSurfaceIntersectsItself_data()
    {
        QTest::addColumn<QString>("patient");
        for (const char* who : {"adult", "child", "adult, obese", "newborn, 50 cm, girl"})
            QTest::newRow(who) << QString::fromLatin1(who);
    }
    void noSurfaceIntersectsItself()
    {
        QFETCH(QString, patient);
        const auto sweep =
            anatomyCommand().run({QStringLiteral("sweep"), QStringLiteral("--patient"), patient,
                                  QStringLiteral("--seeds"), QStringLiteral("0"),
                                  QStringLiteral("--level"), QStringLiteral("0")});
        QVERIFY2(sweep.has_value(), sweep ? "" : sweep.error().detail.c_str());
        QCOMPARE((*sweep)[QStringLiteral("combinations")].toInt(), kLimits);
        QCOMPARE((*sweep)[QStringLiteral("self_intersecting")].toInt(), 0);
        for (const QJsonValue bad : (*sweep)[QStringLiteral("bad")].toArray())
            QCOMPARE(bad[QStringLiteral("part")].toString(), QStringLiteral("Skin"));
    }
};

CARINA_TEST(TestAnatomySweep)

} // namespace carina::lab::anatomy_sweep_test

#include "tst_anatomy_sweep.moc"
