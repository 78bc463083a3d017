#include "widgets/report/registration_report.h"

#include "tests/support/test_class.h"
#include "tests/widgets/report/whole_report.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <csignal>
#include <sys/resource.h>

namespace carina::registration_report_file_test
{
namespace
{

QString letters(const char* words) { return QString::fromUtf8(words); }

/// While it lives, files cannot grow beyond so many bytes: a disk that gets full.
class FullDisk
{
public:
    explicit FullDisk(rlim_t bytes)
    {
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit limit{bytes, m_before.rlim_max};
        m_handler = std::signal(SIGXFSZ, SIG_IGN);
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk()
    {
        setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_handler);
    }
    Q_DISABLE_COPY_MOVE(FullDisk)

private:
    rlimit m_before{};
    void (*m_handler)(int) = nullptr;
};

QByteArray bytesOf(const QString& file)
{
    QFile source{file};
    source.open(QIODevice::ReadOnly);
    return source.readAll();
}

void put(const QString& file, const QByteArray& bytes)
{
    QFile target{file};
    target.open(QIODevice::WriteOnly);
    target.write(bytes);
}

} // namespace

class RegistrationReportFileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// It names its operator.
    void isForItsOwnerAlone_data()
    {
        QTest::addColumn<bool>("wasThere");
        QTest::newRow("new") << false;
        QTest::newRow("in place of one for everybody") << true;
    }
    void isForItsOwnerAlone()
    {
        QFETCH(const bool, wasThere);
        const QString file = m_folder.filePath(letters(wasThere ? "old.pdf" : "new.pdf"));
        if (wasThere) {
            put(file, "old");
            QVERIFY(QFile::setPermissions(file, QFile::ReadOwner | QFile::WriteOwner
                                                    | QFile::ReadGroup | QFile::ReadOther));
        }
        QVERIFY(writeRegistrationReport(file.toStdString(), test::wholeReport()));
        const auto ofOthers =
            QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
        QCOMPARE(QFile::permissions(file) & ofOthers, QFile::Permissions{});
        QVERIFY(bytesOf(file).startsWith("%PDF"));
    }

    void refusesWhatCannotBeWritten_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("no such folder") << letters("absent/report.pdf");
        QTest::newRow("a folder") << letters(".");
        QTest::newRow("below a file") << letters("file/report.pdf");
        QTest::newRow("too long a name") << QString(300, QLatin1Char{'x'});
    }
    void refusesWhatCannotBeWritten()
    {
        QFETCH(QString, name);
        put(m_folder.filePath(letters("file")), "old");
        const std::filesystem::path file = m_folder.filePath(name).toStdString();
        const auto result = writeRegistrationReport(file, test::wholeReport());
        QVERIFY(!result);
        QCOMPARE(result.error().code, Errc::FileUnwritable);
        QVERIFY(result.error().detail.starts_with(file.string()));
    }

    void leavesTheOldFileWhereTheDiskIsFull()
    {
        const QString file = m_folder.filePath(letters("old.pdf"));
        put(file, "old");
        const QStringList before = QDir{m_folder.path()}.entryList();
        {
            const FullDisk disk{4096};
            const auto result = writeRegistrationReport(file.toStdString(), test::wholeReport());
            QVERIFY(!result);
            QCOMPARE(result.error().code, Errc::FileUnwritable);
        }
        QCOMPARE(bytesOf(file), QByteArray{"old"});
        QCOMPARE(QDir{m_folder.path()}.entryList(), before);
        QVERIFY(writeRegistrationReport(file.toStdString(), test::wholeReport()));
        QVERIFY(bytesOf(file).startsWith("%PDF-"));
    }

private:
    QTemporaryDir m_folder;
};

CARINA_SCREEN_TEST(RegistrationReportFileTest)

} // namespace carina::registration_report_file_test

#include "tst_registration_report_file.moc"
