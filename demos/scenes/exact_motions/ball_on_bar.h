// The exact motion of a ball that hangs on a massless bar by a point of its surface: a double pendulum with a
// massless first link. The reference for the pendulum wave.
//
//   l^2 a'' + l r cos(a-b) b'' + l r sin(a-b) b'^2 + g l sin a = 0
//   (r^2 + k^2) b'' + l r cos(a-b) a'' - l r sin(a-b) a'^2 + g r sin b = 0,     k^2 = 2/5 r^2
//
// Symbols: a angle of the bar, b angle of the line from the point of attachment to the centre, both from the
// vertical [rad]; l length of the bar, r radius [m]; g gravity [m/s^2]. The mass cancels.
#pragma once

namespace pushfactor::demos::scenes {

struct BallOnBar {
    double length = 1.0;    // l
    double radius = 0.1;    // r
    double gravity = 10.0;  // g
};

struct Swing {
    double a = 0.0, b = 0.0;            // rad
    double a_rate = 0.0, b_rate = 0.0;  // rad/s
};

// Advances by `time` [s] in `steps` steps of the classical Runge-Kutta method.
Swing advance(const BallOnBar& pendulum, Swing swing, double time, int steps);

// The angle of the ball's centre as seen from where the bar hangs [rad].
double centre_angle(const BallOnBar& pendulum, const Swing& swing);

// The period [s] of the slow swing that begins at rest with bar and ball aligned at `amplitude` [rad]. The bar and
// the ball also swing against each other, faster; a smoothly weighted mean over several periods averages that out.
double period(const BallOnBar& pendulum, double amplitude);

// The length of bar [m] that gives `wanted` [s] as period; that of `pendulum` is ignored. 0 if none is short
// enough.
double length_for_period(BallOnBar pendulum, double amplitude, double wanted);

}  // namespace pushfactor::demos::scenes
