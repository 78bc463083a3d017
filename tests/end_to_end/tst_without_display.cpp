#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QProcess>

namespace carina::without_display_test
{

/// The programs where no window can be shown: they end with a sentence, and do not crash.
class TestWithoutDisplay : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysWhatIsWrong_data()
    {
        QTest::addColumn<QString>("display");
        QTest::addColumn<QString>("program");
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("said");
        QTest::addColumn<int>("status");
        const QStringList wrongSize{QStringLiteral("--size"), QStringLiteral("foo")};
        const QStringList unknown{QStringLiteral("--bogus")};
        for (const char* display : {"", ":31999"})
            for (const auto& [name, path, right] : programs()) {
                const QString where = QString::fromLatin1(display);
                const auto row = [&](const char* what) -> QTestData& {
                    return QTest::addRow("%s, %s, display '%s'", name, what, display);
                };
                row("size") << where << path << wrongSize << QStringLiteral("--size needs WxH")
                            << 2;
                row("unknown") << where << path << unknown << QStringLiteral("option --bogus") << 2;
                row("no value") << where << path << QStringList{QStringLiteral("--size")}
                                << QStringLiteral("after '--size'") << 2;
                row("nothing wrong") << where << path << right << QStringLiteral("no display") << 1;
            }
    }
    void saysWhatIsWrong()
    {
        QFETCH(QString, display);
        QFETCH(QString, program);
        QFETCH(QStringList, arguments);
        QFETCH(QString, said);
        QFETCH(int, status);
        QProcessEnvironment around = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
            around.remove(QString::fromLatin1(name));
        if (!display.isEmpty())
            around.insert(QStringLiteral("DISPLAY"), display);
        QProcess process;
        process.setProcessEnvironment(around);
        process.start(program, arguments);
        QVERIFY(process.waitForFinished(kPatience_ms));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), status);
        const QByteArray words = process.readAllStandardError();
        QVERIFY2(words.contains(said.toUtf8()), words.constData());
        QVERIFY2(words.count('\n') == 1, words.constData()); // that sentence alone
        QCOMPARE(words.contains("--help"), status == 2);
    }

private:
    struct Started {
        const char* name;
        QString path;
        QStringList right;
    };
    static std::vector<Started> programs()
    {
        return {{"registration",
                 QStringLiteral(CARINA_REGISTRATION),
                 {QStringLiteral("--tracker"), QStringLiteral("simulated")}},
                {"instructor", QStringLiteral(CARINA_INSTRUCTOR), {}},
                {"trainee",
                 QStringLiteral(CARINA_TRAINEE),
                 {QStringLiteral("--port"), QStringLiteral("1")}}};
    }
};

CARINA_TEST(TestWithoutDisplay)

} // namespace carina::without_display_test

#include "tst_without_display.moc"
