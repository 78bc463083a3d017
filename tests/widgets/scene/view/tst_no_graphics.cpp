#include "tests/engine/lungs/drawing/lung_like_mesh.h"
#include "tests/support/test_class.h"
#include "widgets/scene/surfaces/drawn_vertices.h"

namespace carina::no_graphics_test
{

class TestNoGraphics : public QObject
{
    Q_OBJECT

public:
    /// Without a display the offscreen platform has no OpenGL.
    static void initMain()
    {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        qunsetenv("DISPLAY");
        qunsetenv("WAYLAND_DISPLAY");
    }

private Q_SLOTS:
    void saysThatNothingCanBeDrawn();
};

void TestNoGraphics::saysThatNothingCanBeDrawn()
{
    const TriangleMesh mesh = test::lungLikeMesh(Vec3::Zero(), Vec3::Constant(0.1), 4, 8);
    const Result<DrawnVertices> drawn = DrawnVertices::of(mesh);
    QVERIFY(!drawn);
    QCOMPARE(drawn.error().code, Errc::NoGraphics);
}

CARINA_SCREEN_TEST(TestNoGraphics)

} // namespace carina::no_graphics_test

#include "tst_no_graphics.moc"
