#include "models/vitals/kept_sounds.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

namespace carina::kept_sounds_test
{
namespace
{

const QString kProgram = QStringLiteral("console");

} // namespace

class TestKeptSounds : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void remembersEachKindByItself()
    {
        const test::ScratchFolder folder;
        KeptSounds sounds{folder.path(), kProgram};
        sounds.keep(SoundKind::Oximeter, {35, false});
        sounds.keep(SoundKind::Alarm, {80, true});
        const KeptSounds next{folder.path(), kProgram};
        QCOMPARE(next.of(SoundKind::Oximeter), (KeptSounds::Loudness{35, false}));
        QCOMPARE(next.of(SoundKind::Alarm), (KeptSounds::Loudness{80, true}));
        QCOMPARE(next.of(SoundKind::Breath), KeptSounds::Loudness{});
        QCOMPARE(next.of(SoundKind::Heart), KeptSounds::Loudness{});
    }

    void remembersThatAllAreMuteForEachProgramByItself()
    {
        const test::ScratchFolder folder;
        KeptSounds sounds{folder.path(), kProgram};
        QVERIFY(!sounds.isMuted());
        sounds.keepMuted(true);
        QVERIFY(sounds.isMuted() && !sounds.of(SoundKind::Alarm).isMuted);
        const KeptSounds next{folder.path(), kProgram};
        QVERIFY(next.isMuted());
        const KeptSounds other{folder.path(), QStringLiteral("trainee")};
        QVERIFY(!other.isMuted());
        sounds.keepMuted(false);
        const KeptSounds after{folder.path(), kProgram};
        QVERIFY(!after.isMuted());
    }

    void soundsAsUsualWhereTheFileIsDamaged()
    {
        const test::ScratchFolder folder;
        folder.write("sounds-console.ini", "[oximeter]\nvolume=loud\n[alarm]\nvolume=4000\n");
        const KeptSounds sounds{folder.path(), kProgram};
        QCOMPARE(sounds.of(SoundKind::Oximeter), KeptSounds::Loudness{});
        QCOMPARE(sounds.of(SoundKind::Alarm).volume_percent, 100);
    }

    /// As they were before each program had its own; from then on each has.
    void beginsWithTheSoundsThatProgramsShared()
    {
        const test::ScratchFolder folder;
        folder.write("sounds.ini", "[oximeter]\nvolume=30\n[heart]\nmuted=true\n");
        KeptSounds sounds{folder.path(), kProgram};
        QCOMPARE(sounds.of(SoundKind::Oximeter), (KeptSounds::Loudness{30, false}));
        QVERIFY(sounds.of(SoundKind::Heart).isMuted);
        sounds.keep(SoundKind::Heart, {55, false});
        folder.write("sounds.ini", "[oximeter]\nvolume=90\n");
        const KeptSounds next{folder.path(), kProgram};
        QCOMPARE(next.of(SoundKind::Oximeter), (KeptSounds::Loudness{30, false}));
        QCOMPARE(next.of(SoundKind::Heart), (KeptSounds::Loudness{55, false}));
    }

    void remembersNothingWithoutAFolder()
    {
        KeptSounds sounds;
        sounds.keep(SoundKind::Heart, {10, true});
        QCOMPARE(sounds.of(SoundKind::Heart).volume_percent, 10);
        QCOMPARE(KeptSounds{}.of(SoundKind::Heart), KeptSounds::Loudness{});
    }
};

CARINA_TEST(TestKeptSounds)

} // namespace carina::kept_sounds_test

#include "tst_kept_sounds.moc"
