#include "apps/lab/commands.h"
#include "engine/core/monotonic_clock.h"
#include "engine/io/site/devices/tracker_file.h"
#include "engine/net/devices/device_tracker.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"

#include <QJsonObject>
#include <QTemporaryDir>

#include <filesystem>
#include <thread>

namespace carina::lab::polaris_command_test
{
namespace
{

using namespace std::chrono_literals;

/// The program's device, which serves while this lives; its patient takes some seconds to make.
class Served
{
public:
    explicit Served(QStringList words)
    {
        words.prepend(m_folder.path());
        m_thread = std::jthread{[words] { static_cast<void>(polarisCommand().run(words)); }};
    }

    [[nodiscard]] std::filesystem::path description() const
    {
        return m_folder.filePath(QStringLiteral("tracker.json")).toStdString();
    }

private:
    QTemporaryDir m_folder;
    std::jthread m_thread;
};

} // namespace

class PolarisCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The fault comes after five seconds.
    void aWiredToolIsUnpluggedAndComesBack()
    {
        const Served served{{QStringLiteral("--seconds"), QStringLiteral("8"),
                             QStringLiteral("--wired"), QStringLiteral("tube"),
                             QStringLiteral("--fault"), QStringLiteral("unplug")}};
        QVERIFY(test::soon([&] { return std::filesystem::exists(served.description()); }, 60s));
        const auto description = readTrackerFile(served.description());
        QVERIFY2(description, description ? "" : description.error().detail.c_str());
        for (const DescribedTool& tool : description->tools)
            QCOMPARE(tool.definition.has_value(), tool.name != "tube");
        const auto tracker = DeviceTracker::make(*description, [] {
            return std::optional{SessionTime{monotonicNow().time_since_epoch()}};
        });
        QVERIFY(tracker && (*tracker)->start());
        const auto tools = (*tracker)->tools();
        const auto tube = std::size_t(
            std::ranges::find(tools, std::string{"tube"}, &TrackedTool::name) - tools.begin());
        const auto stylus = std::size_t(
            std::ranges::find(tools, std::string{"stylus"}, &TrackedTool::name) - tools.begin());
        const auto isSeen = [&](std::size_t tool) {
            const auto newest = tools[tool].history->newest();
            return newest && newest->validity != Validity::Lost;
        };
        QVERIFY(test::soon([&] { return isSeen(tube); }, 20s));
        QVERIFY(test::soon(
            [&] { return (*tracker)->trouble().ends_with("tube: nothing is plugged in for it"); },
            20s));
        QVERIFY(!isSeen(tube) && isSeen(stylus));
        QVERIFY(test::soon([&] { return isSeen(tube); }, 20s));
        QCOMPARE((*tracker)->trouble(), std::string{});
    }

    void refusesOtherWords()
    {
        const QTemporaryDir folder;
        for (const QStringList& words :
             {QStringList{},
              {folder.path(), QStringLiteral("--wired"), QStringLiteral("bougie")},
              {folder.path(), QStringLiteral("--hide"), QStringLiteral("bougie")},
              {folder.path(), QStringLiteral("--fault"), QStringLiteral("unplug")}}) {
            const auto object = polarisCommand().run(words);
            QVERIFY(!object);
            QCOMPARE(object.error().code, Errc::WrongOption);
        }
    }
};

CARINA_TEST(PolarisCommandTest)

} // namespace carina::lab::polaris_command_test

#include "tst_polaris_command.moc"
