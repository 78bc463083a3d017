#include "widgets/scene/view/graphics.h"

#include "engine/core/expects.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>

namespace carina
{

void prepareGraphics()
{
    CARINA_EXPECTS(QGuiApplication::instance() == nullptr);
    qputenv("QT3D_RENDERER", "opengl");
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setSamples(0);
    format.setSwapInterval(0);
    QSurfaceFormat::setDefaultFormat(format);
}

Result<QString> graphicsDriver()
{
    CARINA_EXPECTS(QGuiApplication::instance() != nullptr);
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext context;
    if (!context.create() || !context.makeCurrent(&surface))
        return fail(Errc::NoGraphics, "no OpenGL context");
    const QSurfaceFormat format = context.format();
    if (format.version() < std::pair(3, 3) || context.isOpenGLES())
        return fail(Errc::NoGraphics, "OpenGL " + std::to_string(format.majorVersion()) + "."
                                          + std::to_string(format.minorVersion()));
    const GLubyte* name = context.functions()->glGetString(GL_RENDERER);
    return QString::fromLatin1(reinterpret_cast<const char*>(name));
}

} // namespace carina
