#include "tests/end_to_end/program.h"

#include <QTemporaryDir>

namespace
{

constexpr int kPatience_ms = 60'000; ///< for a scripted technician on a busy machine

} // namespace

/// The wizard, worked by a scripted technician and killed without warning on every page.
class TestRegistration : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void standsWhereItStoodWhenItWasKilled()
    {
        QTemporaryDir folder;
        QVERIFY(folder.isValid());
        const QStringList common{QStringLiteral("--simulated-tracker"), QStringLiteral("--patient"),
                                 QStringLiteral("child"), QStringLiteral("--site"),
                                 folder.filePath(QStringLiteral("site.json"))};
        Program technician{
            QStringLiteral(CARINA_REGISTRATION),
            common
                + QStringList{QStringLiteral("--measure"), folder.filePath(QStringLiteral("out"))},
            folder.filePath(QStringLiteral("technician.jsonl"))};
        Program observer{QStringLiteral(CARINA_REGISTRATION),
                         common + QStringList{QStringLiteral("--hands"), QStringLiteral("off")},
                         folder.filePath(QStringLiteral("observer.jsonl"))};
        for (const char* step : {"tracker", "stylus", "landmarks", "touch", "fit", "verify"}) {
            technician.start();
            const auto isThere = [&] {
                const QJsonObject shown = technician.shown();
                const bool midway = QLatin1String{step} != QLatin1String{"touch"}
                                    || shown[QStringLiteral("touched")].toInt() == 2;
                return shown[QStringLiteral("step")].toString() == QLatin1String{step} && midway;
            };
            QTRY_VERIFY_WITH_TIMEOUT(isThere(), kPatience_ms);
            technician.kill();
            const QJsonObject last = technicianShowed(folder);

            observer.start();
            QTRY_VERIFY_WITH_TIMEOUT(!observer.shown().isEmpty(), kPatience_ms);
            QCOMPARE(observer.shown(), last);
            observer.kill();
        }
        technician.start();
        QTRY_VERIFY_WITH_TIMEOUT(technician.hasEnded(), kPatience_ms);
        QCOMPARE(technician.exitCode(), 0);
    }

private:
    /// The last whole line of the technician's journal, whichever run wrote it.
    static QJsonObject technicianShowed(const QTemporaryDir& folder)
    {
        QFile file{folder.filePath(QStringLiteral("technician.jsonl"))};
        if (!file.open(QIODevice::ReadOnly))
            return {};
        const QByteArrayList lines = file.readAll().split('\n');
        return QJsonDocument::fromJson(lines.value(lines.size() - 2)).object();
    }
};

QTEST_GUILESS_MAIN(TestRegistration)
#include "tst_registration.moc"
