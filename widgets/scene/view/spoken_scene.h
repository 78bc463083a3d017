#pragma once

#include <QWidget>
#include <QWindow>

namespace carina
{

/// Tells programs that read windows aloud what the container of a scene's window is: a picture, of
/// the name that the container's parent has, which has the focus while the scene's window has the
/// keyboard. Qt gives it no name, and says then that nothing has the focus.
/// @param window of the scene, within the container
void speakScene(QWidget& container, const QWindow& window);

} // namespace carina
